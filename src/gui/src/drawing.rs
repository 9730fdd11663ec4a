//! What draws the window: Direct3D 12 on Windows, OpenGL elsewhere and where Windows has no Direct3D 12.
//!
//! Windows has OpenGL only from the maker of the graphics card: not over remote desktop, not in most virtual machines. Direct3D 12 is a part of
//! Windows 10 and later, with a driver in software (WARP) that serves where no card does. On Linux Mesa has such a driver for OpenGL.
//!
//! wgpu's checks of indirect calls stay on, although nothing here makes such calls: they compile a shader while the device is made, so that a
//! system without a shader compiler (Wine 8) is refused there, where OpenGL can still be tried, and not with a panic at the first picture.

use eframe::Renderer;
use std::cell::Cell;
use std::rc::Rc;

/// The ways to draw here, the one to try first in front.
fn ways() -> Vec<(&'static str, Renderer)> {
    vec![
        #[cfg(windows)]
        ("Direct3D 12", Renderer::Wgpu),
        ("OpenGL", Renderer::Glow),
    ]
}

/// Opens the window by the first way that works; `open` sets its flag as soon as the window stands.
///
/// # Errors
/// A sentence with what each way said. A window that stood and fails later is not opened again: what was in it is gone, and the user has to know.
pub fn run(open: impl Fn(Renderer, &Rc<Cell<bool>>) -> eframe::Result) -> Result<(), String> {
    first_that_works(ways(), open)
}

fn first_that_works<Way, E: std::fmt::Display>(
    ways: Vec<(&'static str, Way)>,
    open: impl Fn(Way, &Rc<Cell<bool>>) -> Result<(), E>,
) -> Result<(), String> {
    let opened = Rc::new(Cell::new(false));
    let mut said = Vec::new();
    for (name, way) in ways {
        if let Some(refused) = said.last() {
            dashpot_output::warn(&format!("dashpot: {refused}; trying {name}"));
        }
        match open(way, &opened) {
            Ok(()) => return Ok(()),
            Err(error) => said.push(format!("{name}: {error}")),
        }
        if opened.get() {
            break;
        }
    }
    Err(said.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_next_way_is_tried_only_where_no_window_stood() {
        let tried = Cell::new(0);
        let open = |stands: bool| {
            tried.set(0);
            first_that_works(vec![("a", 1), ("b", 2)], |way, opened| {
                tried.set(way);
                opened.set(stands);
                if way == 2 { Ok(()) } else { Err("no driver") }
            })
        };
        assert_eq!(open(false), Ok(()));
        assert_eq!(tried.get(), 2);
        assert_eq!(open(true), Err("a: no driver".to_string()));
        assert_eq!(tried.get(), 1);
        let nothing = first_that_works(vec![("a", 1), ("b", 2)], |_, _| Err::<(), _>("no driver"));
        assert_eq!(nothing, Err("a: no driver; b: no driver".to_string()));
    }
}
