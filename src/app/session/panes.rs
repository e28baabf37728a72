//! The panes of a comparison: what each shows, and which of them a change goes to.

use crate::scene::parameter::{List, Parameter};
use crate::scene::{Compare, Scene};

/// A parameter and the index of the light that it belongs to.
pub(super) type Change = (&'static Parameter, usize);

/// The active pane, and the scenes of all panes.
#[derive(Debug, Default)]
pub struct Panes {
    /// Index of the pane whose scene the controls show.
    pub active: usize,
    /// True if changes apply to the active pane alone.
    pub own: bool,
    /// The document's scene, from which the others are derived; the first pane shows it.
    pub(super) document: Scene,
    /// The scenes of the panes after the first.
    pub(super) others: Vec<Scene>,
}

impl Panes {
    /// Returns the scene that a pane shows.
    pub fn scene(&self, pane: usize) -> &Scene {
        pane.checked_sub(1)
            .and_then(|index| self.others.get(index))
            .unwrap_or(&self.document)
    }

    /// Returns the differences between a scene and that of the active pane.
    pub(super) fn changes(&self, scene: &Scene) -> Vec<Change> {
        let before = self.scene(self.active);
        before
            .differences(scene)
            .filter(|(parameter, _)| parameter.section() != "compare")
            .collect()
    }
}

/// Returns whether panes cannot differ in a parameter.
fn is_shared(parameter: &Parameter) -> bool {
    Compare::shares(parameter.key) || parameter.section() == "about"
}

/// Sends each change of the active pane to the document, or to the pane itself. A change of the first pane alone is
/// kept from the other panes, which get the previous value as a setting.
pub(super) fn distribute(document: &mut Scene, panes: &Panes, after: &Scene, changes: &[Change]) {
    let before = panes.scene(panes.active);
    // Lights, and changes of a model's materials, are added and removed for all.
    let renewed = |list: List| list.len(before) != list.len(after);
    if renewed(List::Lights) {
        document.lights.clone_from(&after.lights);
    }
    if renewed(List::Materials) {
        let materials = &mut document.object.materials;
        materials.clone_from(&after.object.materials);
    }
    for &(parameter, index) in changes
        .iter()
        .filter(|(parameter, _)| !List::of(parameter.key).is_some_and(renewed))
    {
        let key = parameter.key(index);
        let alone = panes.own && !is_shared(parameter);
        let compared = &mut document.compare.panes;
        match panes
            .active
            .checked_sub(1)
            .and_then(|pane| compared.get_mut(pane))
        {
            Some(pane) if alone || pane.value(&key).is_some() => {
                pane.put(&key, &parameter.setting(after, index));
                continue;
            }
            None if alone => {
                let kept = parameter.setting(before, index);
                compared
                    .iter_mut()
                    .filter(|pane| pane.value(&key).is_none())
                    .for_each(|pane| pane.put(&key, &kept));
            }
            _ => {}
        }
        parameter.copy(after, document, index);
    }
}

/// Removes settings of panes that the document no longer allows, such as a key of a removed light.
pub(super) fn mend(document: &mut Scene) {
    for place in 0..document.compare.panes.len() {
        if document.pane(place + 1).is_ok() {
            continue;
        }
        let settings = std::mem::take(&mut document.compare.panes[place].set);
        for setting in settings {
            document.compare.panes[place].set.push(setting);
            if document.pane(place + 1).is_err() {
                document.compare.panes[place].set.pop();
            }
        }
    }
}
