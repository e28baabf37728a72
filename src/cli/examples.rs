//! The examples at the start of the program's and each command's help, also in the manual pages. They are as typed,
//! in any language; a test parses them.

pub fn examples(command: &str) -> &'static [&'static str] {
    match command {
        "render" => &[
            "shading-lab render teapot -o teapot.png --size 1920x1080 --samples 16",
            "shading-lab render sphere -o sphere.png --set material.n=1005 --overlay vectors,angles",
        ],
        "animate" => &[
            "shading-lab animate teapot --set-from material.n=5 --set-to material.n=1005 -o sweep.png",
            "shading-lab animate teapot --set-from camera.roll=0 --set-to camera.roll=360 -o roll.gif",
        ],
        "probe" => &["shading-lab probe sphere --pixel 380,300"],
        "profile" => &[
            "shading-lab profile mach-bands --from 100,384 --to 668,384 --csv profile.csv",
            "shading-lab profile mach-bands --from 100,384 --to 668,384 -o profile.svg",
        ],
        "compare" => &[
            "shading-lab compare flat-facets --pane shading.mode=gouraud --pane shading.mode=exact",
        ],
        "normals" => &["shading-lab normals vertex-normals --pixel 384,384"],
        "defects" => &["shading-lab defects silhouette --json"],
        "conditions" => &["shading-lab conditions flat-facets"],
        "explain" => &["shading-lab explain shadows"],
        "scanline" => &["shading-lab scanline orientation -o scanline.svg"],
        "study" => &[
            "shading-lab study sphere --methods flat,gouraud,phong --segments 8,16,32 -o study.png",
        ],
        "stability" => &[
            "shading-lab stability --csv stability.csv",
            "shading-lab stability ward -o stability.png",
        ],
        "code" => &["shading-lab code spotlight --target glsl -o spotlight"],
        "link" => &[
            "shading-lab link highlight --set material.n=50",
            "shading-lab link highlight -o code.svg --url https://example.org/shading-lab/",
        ],
        "curves" => &["shading-lab curves highlight --kind exponent -o curves.png"],
        "scenes" => &["shading-lab scenes"],
        "materials" => &[
            "shading-lab materials",
            "shading-lab render teapot --material gold -o gold.png",
        ],
        "parameters" => &["shading-lab parameters --json"],
        "check" => &[
            "shading-lab check scene.toml",
            "shading-lab check lesson.md --json",
        ],
        "lesson" => &[
            "shading-lab lesson",
            "shading-lab lesson ambient -o ambient.html",
        ],
        "class" => &[
            "shading-lab class mach-bands",
            "shading-lab class mach-bands --rehearse 30",
        ],
        "collect" => {
            &["shading-lab collect answers/anna.png answers/ben.png -o class.html --csv class.csv"]
        }
        "bench" => &["shading-lab bench teapot --frames 100 --threads 4"],
        "completions" => &[
            "shading-lab completions bash > ~/.local/share/bash-completion/completions/shading-lab",
        ],
        "manual" => &[
            "shading-lab manual | man -l -",
            "shading-lab manual -o man1",
        ],
        "help" => &["shading-lab help render"],
        _ => &[
            "shading-lab teapot",
            "shading-lab render teapot -o teapot.png",
            "shading-lab probe sphere --pixel 380,300",
        ],
    }
}
