//! The responses to requests. [`super`] describes the protocol.

use super::content::StepContent;
use super::events::events;
use super::files::StaticFile;
use super::limits;
use super::page::{SCRIPT, STYLE, shell};
use super::refusal::Refusal;
use super::room::{AnswerRequest, Room};
use super::tokens::Token;
use crate::text::text;
use axum::Router;
use axum::body::Body;
use axum::extract::{Path, Request, State};
use axum::http::header::{self, HeaderMap, HeaderValue};
use axum::http::{StatusCode, Uri};
use axum::middleware::map_response;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use hyper::body::Body as _;
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::future::poll_fn;
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::timeout;

/// The longest time that a body may take.
const BODY_TIME: Duration = Duration::from_secs(10);

/// The policy of the page: it uses what comes from here, and nothing else.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
/// The policy of the program's page, whose own is stricter.
const LAB_POLICY: &str = "default-src 'self' 'wasm-unsafe-eval' blob: data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const YEAR: &str = "public, max-age=31536000, immutable";
const DAY: &str = "public, max-age=86400";
const NEVER: &str = "no-store";

/// The state that all requests share.
pub struct Shared {
    room: Arc<Room>,
    script: StaticFile,
    style: StaticFile,
    /// The program's page by its paths, where its files were found.
    lab: Option<HashMap<String, StaticFile>>,
}

impl Shared {
    /// Prepares what a class's phones ask for.
    pub fn new(room: Arc<Room>, lab: Option<HashMap<String, StaticFile>>) -> Self {
        Self {
            room,
            script: StaticFile::new("class.js", SCRIPT),
            style: StaticFile::new("class.css", STYLE),
            lab,
        }
    }
}

type Class = State<Arc<Shared>>;

/// Returns the router of a class.
pub fn router(shared: Shared) -> Router {
    let code = shared.room.head().code.clone();
    let below = |path: &str| format!("/{code}/{path}");
    Router::new()
        .route(&format!("/{code}"), get(to_folder))
        .route(&below(""), get(page))
        .route(&below("class.js"), get(script))
        .route(&below("class.css"), get(style))
        .route(&below("join"), post(join))
        .route(&below("events"), get(follow))
        .route(&below("answers"), post(answer))
        .route(&below("turn"), post(turn))
        .route(&below("steps/{step}"), get(question))
        .route(&below("steps/{step}/explanation"), get(explanation))
        .route(&below("steps/{step}/{picture}"), get(picture))
        .route(&below("lab/"), get(lab_page))
        .route(&below("lab/{*path}"), get(lab))
        .fallback(nothing)
        .method_not_allowed_fallback(nothing)
        .layer(map_response(protected))
        .with_state(Arc::new(shared))
}

/// Adds what protects every answer.
async fn protected(mut response: Response) -> Response {
    let headers = response.headers_mut();
    for (name, value) in [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::CACHE_CONTROL, NEVER),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
    ] {
        let entry = headers.entry(name);
        entry.or_insert(HeaderValue::from_static(value));
    }
    response
}

/// Returns the response to a refused request, with its sentence.
fn refused(status: StatusCode, words: &str) -> Response {
    (status, json_body(&json!({ "error": words }))).into_response()
}

fn json_body(value: &Value) -> impl IntoResponse + use<> {
    let kind = HeaderValue::from_static("application/json");
    ([(header::CONTENT_TYPE, kind)], value.to_string())
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let (status, words) = match &self {
            Self::NoStudent => (StatusCode::UNAUTHORIZED, text!("live-no-student")),
            Self::NotOpen(own) => {
                let pace = json!({ "error": text!("live-not-open"), "pace": own });
                return (StatusCode::CONFLICT, json_body(&pace)).into_response();
            }
            Self::Unfit => (StatusCode::BAD_REQUEST, text!("live-unfit")),
            Self::TooFast => (StatusCode::TOO_MANY_REQUESTS, text!("live-too-fast")),
            Self::Full => (StatusCode::SERVICE_UNAVAILABLE, text!("live-full")),
            Self::NotYet => (StatusCode::FORBIDDEN, text!("live-not-yet")),
            Self::NoStep => (StatusCode::NOT_FOUND, text!("live-nothing")),
            Self::Malformed => (StatusCode::BAD_REQUEST, text!("live-malformed")),
            Self::TooLong => (StatusCode::PAYLOAD_TOO_LARGE, text!("live-too-long")),
            Self::TooSlow => (StatusCode::REQUEST_TIMEOUT, text!("live-too-slow")),
            Self::Problem(words) => (StatusCode::INTERNAL_SERVER_ERROR, words.as_str()),
            Self::Failed(words) => (StatusCode::INSUFFICIENT_STORAGE, words.as_str()),
        };
        refused(status, words)
    }
}

async fn nothing() -> Refusal {
    Refusal::NoStep
}

/// Leads to the folder, so that what is relative to it is found.
async fn to_folder(State(shared): Class) -> Response {
    let folder = format!("{}/", shared.room.head().code);
    let place = HeaderValue::from_str(&folder).unwrap_or(HeaderValue::from_static("./"));
    (StatusCode::TEMPORARY_REDIRECT, [(header::LOCATION, place)]).into_response()
}

async fn page(State(shared): Class) -> Response {
    let room = &shared.room;
    match room.content().prepared(room.pace().step).await {
        Ok(step) => html(shell(room.lesson(), &step.page, shared.lab.is_some())),
        Err(problem) => Refusal::Problem(problem).into_response(),
    }
}

fn html(text: String) -> Response {
    let kind = HeaderValue::from_static("text/html; charset=utf-8");
    ([(header::CONTENT_TYPE, kind)], text).into_response()
}

async fn script(State(shared): Class, headers: HeaderMap) -> Response {
    given(&shared.script, &headers, YEAR)
}

async fn style(State(shared): Class, headers: HeaderMap) -> Response {
    given(&shared.style, &headers, YEAR)
}

/// Gives out a file, compressed where that is accepted, or says that it has not changed.
fn given(file: &StaticFile, headers: &HeaderMap, kept: &'static str) -> Response {
    let accepted = headers.get(header::ACCEPT_ENCODING);
    let accepted = accepted.and_then(|value| value.to_str().ok()).unwrap_or("");
    let accepts = |name: &str| accepted.split(',').any(|one| one.trim() == name);
    let [gzip, brotli] = &file.compressed;
    let (encoding, bytes) = match (brotli, gzip) {
        (Some(bytes), _) if accepts("br") => (Some("br"), bytes),
        (_, Some(bytes)) if accepts("gzip") => (Some("gzip"), bytes),
        _ => (None, &file.bytes),
    };
    let tag = format!("\"{}{}\"", file.hash, encoding.unwrap_or_default());
    let known = headers.get(header::IF_NONE_MATCH);
    let fresh = known.is_some_and(|known| known.as_bytes() == tag.as_bytes());
    let mut response = if fresh {
        StatusCode::NOT_MODIFIED.into_response()
    } else {
        let kind = HeaderValue::from_static(file.kind);
        ([(header::CONTENT_TYPE, kind)], bytes.clone()).into_response()
    };
    let headers = response.headers_mut();
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(kept));
    headers.insert(header::VARY, HeaderValue::from_static("Accept-Encoding"));
    if let Ok(tag) = HeaderValue::from_str(&tag) {
        headers.insert(header::ETAG, tag);
    }
    if let Some(encoding) = encoding.filter(|_| !fresh) {
        headers.insert(header::CONTENT_ENCODING, HeaderValue::from_static(encoding));
    }
    response
}

/// Finds the token among the cookies.
fn token(headers: &HeaderMap) -> Option<Token> {
    let cookies = headers.get_all(header::COOKIE).into_iter();
    let texts = cookies.filter_map(|value| value.to_str().ok());
    let mut pairs = texts.flat_map(|text| text.split(';'));
    pairs.find_map(|pair| Token::read(pair.trim().strip_prefix("token=")?))
}

/// Reads the body of a request, which may be neither too long nor too slow.
async fn body(request: Request) -> Result<Vec<u8>, Refusal> {
    let length = request.body().size_hint().lower();
    if length > limits::BODY as u64 {
        return Err(Refusal::TooLong);
    }
    let mut body = pin!(request.into_body());
    let mut bytes = Vec::with_capacity(length as usize);
    let read = async {
        while let Some(frame) = poll_fn(|context| body.as_mut().poll_frame(context)).await {
            let frame = frame.map_err(|_| Refusal::Malformed)?;
            bytes.extend(frame.into_data().unwrap_or_default());
            if bytes.len() > limits::BODY {
                return Err(Refusal::TooLong);
            }
        }
        Ok(())
    };
    let read = timeout(BODY_TIME, read).await;
    read.map_err(|_| Refusal::TooSlow)?.map(|()| bytes)
}

/// A student's words about themselves.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Introduction {
    #[serde(default)]
    name: Option<String>,
}

async fn join(State(shared): Class, request: Request) -> Result<Response, Refusal> {
    let known = token(request.headers());
    let bytes = body(request).await?;
    let introduction: Introduction = match bytes.trim_ascii() {
        [] => Introduction::default(),
        bytes => read_json(bytes)?,
    };
    let token = shared.room.join(known, introduction.name.as_deref())?;
    // Without a path it holds for the folder of the class, whatever stands before that.
    let cookie = format!("token={token}; Max-Age=86400; HttpOnly; SameSite=Strict");
    let steps = shared.room.lesson().steps.len();
    let body = json_body(&json!({ "steps": steps }));
    Ok(([(header::SET_COOKIE, cookie)], body).into_response())
}

fn read_json<T: for<'de> Deserialize<'de>>(bytes: &[u8]) -> Result<T, Refusal> {
    serde_json::from_slice(bytes).map_err(|_| Refusal::Malformed)
}

/// Lets in a request of a student, who may not make too many.
fn admitted(shared: &Shared, headers: &HeaderMap) -> Result<Token, Refusal> {
    shared.room.admit(token(headers))
}

async fn follow(State(shared): Class, headers: HeaderMap) -> Result<Response, Refusal> {
    let token = admitted(&shared, &headers)?;
    let events = events(&shared.room, token)?;
    let kind = HeaderValue::from_static("text/event-stream");
    let mut response = Response::new(Body::new(events));
    response.headers_mut().insert(header::CONTENT_TYPE, kind);
    // A proxy must not collect what is to be seen at once.
    let no = HeaderValue::from_static("no");
    response.headers_mut().insert("x-accel-buffering", no);
    Ok(response)
}

async fn answer(State(shared): Class, request: Request) -> Result<Response, Refusal> {
    let token = admitted(&shared, request.headers())?;
    let bytes = body(request).await?;
    let answer: AnswerRequest = read_json(&bytes)?;
    match shared.room.answer(token, answer)?.await {
        Ok(Ok(())) => Ok(json_body(&json!({ "saved": true })).into_response()),
        Ok(Err(words)) => Err(Refusal::Failed(words)),
        Err(_) => Err(Refusal::Failed(text!("live-over").to_owned())),
    }
}

/// The step that a student turns to.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TurnRequest {
    /// The step, from 1.
    step: usize,
}

async fn turn(State(shared): Class, request: Request) -> Result<Response, Refusal> {
    let token = admitted(&shared, request.headers())?;
    let TurnRequest { step } = read_json(&body(request).await?)?;
    shared.room.turn(token, step)?;
    Ok(json_body(&json!({ "step": step })).into_response())
}

async fn question(
    State(shared): Class,
    Path(step): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let content = shown(&shared, &headers, &step, false).await?;
    Ok(html(content.page.html.clone()))
}

async fn explanation(
    State(shared): Class,
    Path(step): Path<String>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let content = shown(&shared, &headers, &step, true).await?;
    Ok(html(content.page.explanation.clone()))
}

/// Returns a step that students may see, once it is prepared.
async fn shown(
    shared: &Shared,
    headers: &HeaderMap,
    step: &str,
    explanation: bool,
) -> Result<Arc<StepContent>, Refusal> {
    admitted(shared, headers)?;
    let step = number(step).ok_or(Refusal::NoStep)?;
    shared.room.may_see(step, explanation)?;
    let prepared = shared.room.content().prepared(step).await;
    prepared.map_err(Refusal::Problem)
}

/// Reads a number of a step or a picture as it is written in addresses.
fn number(text: &str) -> Option<usize> {
    let digits = (1..=3).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| digits)
}

async fn picture(
    State(shared): Class,
    Path((step, picture)): Path<(String, String)>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let (step, picture) = number(&step)
        .zip(picture.strip_suffix(".png").and_then(number))
        .ok_or(Refusal::NoStep)?;
    shared.room.may_see(step, false)?;
    let prepared = shared.room.content().prepared(step).await;
    let content = prepared.map_err(Refusal::Problem)?;
    let index = picture.checked_sub(1).ok_or(Refusal::NoStep)?;
    let file = content.pictures.get(index).ok_or(Refusal::NoStep)?;
    Ok(given(file, &headers, YEAR))
}

async fn lab_page(state: Class, uri: Uri, headers: HeaderMap) -> Response {
    lab(state, Path("index.html".to_owned()), uri, headers).await
}

async fn lab(
    State(shared): Class,
    Path(path): Path<String>,
    uri: Uri,
    headers: HeaderMap,
) -> Response {
    let Some(files) = &shared.lab else {
        return refused(StatusCode::NOT_FOUND, text!("live-no-lab"));
    };
    let Some(file) = files.get(&path) else {
        return Refusal::NoStep.into_response();
    };
    // What is asked for with a version does not change.
    let kept = match (uri.query(), &*path) {
        (_, "index.html") | (None, _) => "no-cache",
        (Some(_), _) => DAY,
    };
    let mut response = given(file, &headers, kept);
    let policy = HeaderValue::from_static(LAB_POLICY);
    response
        .headers_mut()
        .insert(header::CONTENT_SECURITY_POLICY, policy);
    response
}
