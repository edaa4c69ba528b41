//! The engine that suits the length of a run.

use super::{EngineFormat, interpreter};

/// Ticks from which compiling pays.
///
/// Measured: for each op the interpreter takes about 10 ns a tick and Cranelift about 10 us once.
#[cfg(feature = "native")]
const COMPILE_PAYS: u64 = 1_000;

/// Interprets what is over before it could be compiled, and where there is no native code for this machine.
pub(super) static ENGINE: EngineFormat = EngineFormat {
    name: "auto",
    doc: "What suits the length of the run; lanes for a sweep",
    runs_many: true,
    build: |program, ticks| {
        #[cfg(feature = "native")]
        if ticks >= COMPILE_PAYS
            && let Ok(made) = (super::native::ENGINE.build)(std::sync::Arc::clone(&program), ticks)
        {
            return Ok(made);
        }
        (interpreter::ENGINE.build)(program, ticks)
    },
};

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::base::Graph;
    use crate::compile::Program;
    use crate::engine::EngineKind;

    #[test]
    fn auto_interprets_what_is_over_before_it_could_be_compiled() {
        let nothing = Program {
            graph: Graph::default(),
            owner: Vec::new(),
            owners: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            pulses: Vec::new(),
            signals: Vec::new(),
            stop: None,
        };
        let program = Arc::new(nothing);
        let chosen = |ticks| EngineKind::AUTO.build(Arc::clone(&program), ticks).expect("an engine").name();
        assert_eq!(chosen(100), "interpreter");
        assert_eq!(chosen(1_000_000), if cfg!(feature = "native") { "native" } else { "interpreter" });
    }
}
