//! What a scene is about, for its readers.

/// What a scene shows. All of it may be empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct About {
    pub title: String,
    /// What there is to see.
    pub sentence: String,
    /// The chapter that it belongs to.
    pub topic: String,
    /// The tab of the window that shows its point, for example `profile`; opening the scene opens it.
    pub view: String,
}
