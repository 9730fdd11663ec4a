//! Graphics backends of the window: Direct3D 12 on Windows, OpenGL elsewhere and on Windows without Direct3D 12.
//!
//! On Windows, OpenGL needs the driver from the manufacturer of the graphics card. That driver is missing over remote desktop and in most
//! virtual machines. Direct3D 12 is a part of Windows 10 and later, with a software driver (WARP) as a fallback. On Linux, Mesa provides a
//! software driver for OpenGL.
//!
//! wgpu's checks of indirect calls stay enabled, although this program makes no such calls. The checks compile a shader when the device is
//! created. On a system without a shader compiler (Wine 8), Direct3D then fails at this point and OpenGL replaces it. Without the checks,
//! the program would panic at the first frame.

use eframe::Renderer;
use std::cell::Cell;
use std::rc::Rc;

/// Returns the graphics backends with their names. The preferred one comes first.
fn ways() -> Vec<(&'static str, Renderer)> {
    vec![
        #[cfg(windows)]
        ("Direct3D 12", Renderer::Wgpu),
        ("OpenGL", Renderer::Glow),
    ]
}

/// Opens the window with the first backend that works. `open` sets the flag that it receives once the window is open.
///
/// # Errors
/// Returns a sentence with the error of each tried backend. If a window fails after it was open, no further backend is tried. The contents
/// of the window are lost, and the user must know.
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
