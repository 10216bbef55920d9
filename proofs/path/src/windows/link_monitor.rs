// The whole state by name: a new field does not compile until the proofs know it.
impl crate::subject::Link for LinkMonitor {
    fn of(state: crate::subject::LinkState) -> Self {
        let crate::subject::LinkState { ref_loss, threshold, seen, received, lost, missing, cusum } = state;
        let missing = Missing(missing.into_iter().collect());
        Self { ref_loss, threshold, seen, received, lost, missing, cusum }
    }
    fn state(&self) -> crate::subject::LinkState {
        let Self { ref_loss, threshold, seen, received, lost, missing, cusum } = self.clone();
        let missing = missing.0.into_iter().collect();
        crate::subject::LinkState { ref_loss, threshold, seen, received, lost, missing, cusum }
    }
    fn new(ref_loss: f64, threshold: f64) -> Self {
        LinkMonitor::new(ref_loss, threshold)
    }
    fn on_frame(&mut self, seq: i64) {
        LinkMonitor::on_frame(self, seq);
    }
    fn report(&self) -> ncp_spec::resilience::LinkReport {
        let LinkReport { last_seq, received, lost, loss_rate, burst } = LinkMonitor::report(self);
        ncp_spec::resilience::LinkReport { last_seq, received, lost, loss_rate, burst }
    }
    fn loss_rate(&self) -> f64 {
        LinkMonitor::loss_rate(self)
    }
    fn burst(&self) -> bool {
        LinkMonitor::burst(self)
    }
}

impl crate::number::Detector<f64> for LinkMonitor {
    fn new(ref_loss: f64, threshold: f64) -> Self {
        LinkMonitor::new(ref_loss, threshold)
    }
    fn of(ref_loss: f64, threshold: f64, cusum: f64) -> Self {
        Self { ref_loss, threshold, seen: None, received: 0, lost: 0, missing: Missing::default(), cusum }
    }
    fn numbers(&self) -> [f64; 3] {
        [self.ref_loss, self.threshold, self.cusum]
    }
    fn slot(&mut self, by: f64) {
        // Cases that are left aside run on, and std's clamp panics without bounds.
        if self.threshold > 0.0 {
            self.step(by);
        }
    }
    fn on_frame(&mut self, seq: i64) {
        if self.threshold > 0.0 {
            LinkMonitor::on_frame(self, seq);
        }
    }
    fn burst(&self) -> bool {
        LinkMonitor::burst(self)
    }
}
