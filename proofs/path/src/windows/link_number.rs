use crate::number::{Count as _, Number};

type Term = <ncp_proofs::provers::terms::Symbolic as ncp_proofs::prover::Prover>::S;

// The whole state by name: a new field does not compile until the proofs know it.
impl crate::number::Detector<Term> for LinkMonitor {
    fn new(ref_loss: Term, threshold: Term) -> Self {
        LinkMonitor::new(Number::Term(ref_loss), Number::Term(threshold))
    }
    fn of(ref_loss: Term, threshold: Term, cusum: Term) -> Self {
        let [ref_loss, threshold, cusum] = [ref_loss, threshold, cusum].map(Number::Term);
        Self { ref_loss, threshold, seen: None, received: 0, lost: 0, missing: Missing::default(), cusum }
    }
    fn numbers(&self) -> [Term; 3] {
        let Self { ref_loss, threshold, seen: _, received: _, lost: _, missing: _, cusum } = self;
        [*ref_loss, *threshold, *cusum].map(Number::term)
    }
    fn slot(&mut self, by: Term) {
        self.step(Number::Term(by));
    }
    fn on_frame(&mut self, seq: i64) {
        LinkMonitor::on_frame(self, seq);
    }
    fn burst(&self) -> bool {
        LinkMonitor::burst(self)
    }
}
