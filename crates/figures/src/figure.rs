//! A figure of a collapse: what it is called, what stands under it, and how it is drawn.

use outcome::picture::Picture;

/// A kind of figure. Each stands in the file that draws it, and in the list of [`FIGURES`](crate::FIGURES).
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Its name, which its files have.
    pub name: &'static str,
    /// What is said under it.
    pub caption: &'static str,
    /// Draws it as SVG; none where the picture has no material for it.
    pub draw: fn(&Picture) -> Option<String>,
}
