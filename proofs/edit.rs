/// A broken kernel or a broken reader: the source of the real one with one edit.
#[derive(Debug, Clone, Copy)]
pub struct Broken {
    /// Its name, of the family that has to notice it.
    pub id: &'static str,
    /// The file: of the kernel, or of a reader, within `spec/src`.
    pub file: &'static str,
    /// Some text of it that occurs once.
    pub from: &'static str,
    /// What stands there instead.
    pub to: &'static str,
    /// The property that has to refute it.
    pub property: &'static str,
}

#[rustfmt::skip]
const fn broken(
    id: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
    property: &'static str,
) -> Broken {
    Broken { id, file, from, to, property }
}
