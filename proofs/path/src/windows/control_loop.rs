/// The loop with a controller that does what it is told.
pub type Subject = ControlLoop<crate::spies::Scripted>;

// The whole state by name: a new field does not compile until the proofs know it.
impl crate::subject::Loop for Subject {
    type Governor = SafetyGovernor;
    type Link = LinkMonitor;

    fn new(period_ms: f64, governor: SafetyGovernor, link: LinkMonitor) -> Option<Self> {
        ControlLoop::new(LoopConfig { period_ms }, crate::spies::Scripted::default(), governor, link).ok()
    }
    fn of(parts: crate::subject::LoopParts<SafetyGovernor, LinkMonitor>) -> Self {
        let crate::subject::LoopParts { controller, governor, link, period_ms, newest, ticks, t } = parts;
        Self { controller, governor, link, period_ms, newest, ticks, t }
    }
    fn parts(&self) -> crate::subject::LoopParts<SafetyGovernor, LinkMonitor> {
        let Self { controller, governor, link, period_ms, newest, ticks, t } = self;
        crate::subject::LoopParts {
            controller: controller.clone(),
            governor: governor.clone(),
            link: link.clone(),
            period_ms: *period_ms,
            newest: newest.clone(),
            ticks: *ticks,
            t: *t,
        }
    }
    fn on_sensor(&mut self, frame: SensorFrame, now_s: f64) -> bool {
        ControlLoop::on_sensor(self, frame, now_s)
    }
    fn tick(&mut self, now_s: f64, took_ms: f64) -> ncp_spec::control::Tick {
        let Tick { command, status, decision } = ControlLoop::tick(self, now_s, took_ms);
        ncp_spec::control::Tick { command, status, decision }
    }
    fn reset(&mut self) {
        self.governor_mut().reset();
    }
}
