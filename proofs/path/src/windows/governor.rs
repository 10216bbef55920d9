// The whole state by name: a new field does not compile until the proofs know it.
impl crate::subject::Governor for SafetyGovernor {
    fn new(limits: &SafetyLimits) -> Self {
        SafetyGovernor::new(limits)
    }
    fn negotiated(limits: &SafetyLimits, sensor: &[ChannelSpec], command: &[ChannelSpec]) -> Self {
        SafetyGovernor::negotiated(limits, sensor, command)
    }
    fn from_capabilities(capabilities: &Capabilities) -> Self {
        SafetyGovernor::from_capabilities(capabilities)
    }
    fn channels(&self) -> &[(Text, Option<Text>)] {
        let Self { gates: _, channels: Channels(channels) } = self;
        channels
    }
    fn govern(
        &mut self,
        command: &mut CommandFrame,
        now_s: f64,
        sensor: Option<&SensorFrame>,
        last_sensor_s: Option<f64>,
    ) -> Decision {
        SafetyGovernor::govern(self, command, now_s, sensor, last_sensor_s)
    }
    fn note_link(&mut self, burst: bool) {
        SafetyGovernor::note_link(self, burst);
    }
    fn reset(&mut self) {
        SafetyGovernor::reset(self);
    }
    fn is_stopped(&self) -> bool {
        SafetyGovernor::is_stopped(self)
    }
    fn has_config_fault(&self) -> bool {
        SafetyGovernor::has_config_fault(self)
    }
    fn with_ticks<T>(&self, command: &mut CommandFrame, ask: impl FnOnce(&mut dyn crate::subject::Ticks) -> T) -> T {
        struct Window<'a>(Ticks<'a>);
        impl crate::subject::Ticks for Window<'_> {
            fn steps(&self) -> usize {
                self.0.steps()
            }
            fn velocity(&self, tick: usize) -> Option<[f64; 3]> {
                self.0.velocity(tick)
            }
            fn limit(&mut self, tick: usize, max_mps: f64) -> Result<bool, Reason> {
                self.0.limit(tick, Limit::Enabled(max_mps))
            }
            fn truncate(&mut self, steps: usize) {
                self.0.truncate(steps);
            }
            fn tick_mut(&mut self, tick: usize) -> Option<&mut ChannelMap> {
                let Ticks { command, channels: _ } = &mut self.0;
                if tick == 0 { Some(&mut command.channels) } else { command.horizon.get_mut(tick - 1) }
            }
        }
        ask(&mut Window(Ticks { command, channels: &self.channels }))
    }
}
