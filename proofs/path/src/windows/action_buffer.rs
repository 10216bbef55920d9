/// The scanner, and the buffer behind it.
#[derive(Debug, Clone, Copy)]
pub struct Subject;

impl crate::subject::Stopping for Subject {
    fn is_estop(frame: &[u8]) -> bool {
        is_estop(frame)
    }
    fn latches(frame: &[u8], is_strict: bool) -> bool {
        let mut buffer = if is_strict { ActionBuffer::strict() } else { ActionBuffer::new() };
        let _ = buffer.on_frame(frame, 0.0);
        buffer.is_stopped()
    }
}
