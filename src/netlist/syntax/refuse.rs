//! What Verilog has and this subset has not: how each construct is named, what to write instead, where it ends.

/// What to write, in one line.
pub(super) const SUBSET: &str =
    "a circuit holds parameters, wires, routing assigns, gates, instances and generate loops";

/// How to get past a construct.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Skip {
    /// To its `;`, or to the `end` that closes it.
    Statement,
    /// To this word.
    To(&'static str),
}

/// A construct outside the subset.
#[derive(Clone, Copy, Debug)]
pub(super) struct Refused {
    pub(super) construct: &'static str,
    pub(super) instead: &'static str,
    pub(super) skip: Skip,
}

const BEHAVIOUR: &str = "behaviour comes from blocks: place an instance (see `stepwright list blocks`)";
const REGISTER: &str = "state lives in blocks: place a register block and declare its output as `wire`";
const ONE_DRIVER: &str = "declare it as `wire`: nets have two states and one driver";

/// A construct that starts with this word in a module.
pub(super) fn in_module(word: &str) -> Option<Refused> {
    use Skip::{Statement, To};
    let (construct, instead, skip) = match word {
        "always" | "always_ff" | "always_comb" | "always_latch" => ("an `always` block is", BEHAVIOUR, Statement),
        "initial" => ("an `initial` block is", "the power-on state is a parameter of the block", Statement),
        "final" => ("a `final` block is", BEHAVIOUR, Statement),
        "reg" => ("`reg` is", REGISTER, Statement),
        "logic" | "bit" | "byte" | "int" => ("a SystemVerilog type is", "declare it as `wire`", Statement),
        "integer" | "time" | "event" => ("a variable is", REGISTER, Statement),
        "real" | "realtime" => {
            ("a real variable is", "use fixed-point words: `(* fraction = 18 *) wire signed [31:0] x`", Statement)
        }
        "input" | "output" => {
            ("a port declaration in the body is", "write directions and widths in the module's header", Statement)
        }
        "inout" => ("`inout` is", "use one `input` and one `output`: nets have one driver", Statement),
        "tri" | "tri0" | "tri1" | "triand" | "trior" | "trireg" | "wand" | "wor" | "uwire" | "supply0" | "supply1" => {
            ("this kind of net is", ONE_DRIVER, Statement)
        }
        "defparam" => ("`defparam` is", "override at the instance: `#(.WIDTH(12))`", Statement),
        "specparam" => ("`specparam` is", "leave timing out: time is whole ticks", Statement),
        "function" => ("a function is", "use `localparam` for constants and blocks for behaviour", To("endfunction")),
        "task" => ("a task is", BEHAVIOUR, To("endtask")),
        "specify" => ("a `specify` block is", "leave timing out: time is whole ticks", To("endspecify")),
        "if" => ("`generate if` is", "use a parameter of a block, or two modules", Statement),
        "case" => ("`generate case` is", "use a parameter of a block, or several modules", To("endcase")),
        "begin" => ("a bare `begin` block is", "write its items without `begin` and `end`", Statement),
        "bufif0" | "bufif1" | "notif0" | "notif1" => {
            ("a three-state gate is", "use an `and` gate or a multiplexer", Statement)
        }
        "nmos" | "pmos" | "cmos" | "rnmos" | "rpmos" | "rcmos" | "tran" | "tranif0" | "tranif1" | "rtran"
        | "rtranif0" | "rtranif1" | "pullup" | "pulldown" => {
            ("a switch-level primitive is", "use gates or blocks", Statement)
        }
        _ => return None,
    };
    Some(Refused { construct, instead, skip })
}

/// A construct that starts with this word outside modules.
pub(super) fn at_top(word: &str) -> Option<(&'static str, &'static str)> {
    match word {
        "primitive" => Some(("a user-defined primitive is", "use gates or a block")),
        "config" | "library" => Some(("a configuration is", "modules are found by their file's name")),
        "macromodule" => Some(("`macromodule` is", "write `module`")),
        "package" | "interface" | "program" | "class" | "import" => {
            Some(("SystemVerilog is", "write Verilog-2005 modules"))
        }
        _ => None,
    }
}

/// What stands between a direction or `wire` and the names, but must not.
pub(super) fn net_kind(word: &str) -> Option<(&'static str, &'static str)> {
    match word {
        "reg" => Some(("`reg` is", REGISTER)),
        "logic" | "bit" | "int" | "integer" | "var" | "time" => Some(("this type is", "declare it as `wire`")),
        "real" | "realtime" => {
            Some(("`real` is", "use a fixed-point word: `(* fraction = 18 *) wire signed [31:0] x`"))
        }
        "tri" | "tri0" | "tri1" | "triand" | "trior" | "trireg" | "wand" | "wor" | "uwire" | "supply0" | "supply1"
        | "vectored" | "scalared" => Some(("this kind of net is", ONE_DRIVER)),
        _ => None,
    }
}

/// What to write instead of a directive.
pub(super) fn instead_of_directive(directive: &str) -> &'static str {
    match directive {
        "`include" => "a module that is not in this file is found in `<its name>.v`",
        "`define" | "`undef" => "use `parameter` or `localparam`",
        "`ifdef" | "`ifndef" | "`else" | "`elsif" | "`endif" => "use parameters, or two circuits",
        _ => "only `default_nettype` and `timescale` are known; constants are `parameter`s and `localparam`s",
    }
}

/// Drive and charge strengths.
pub(super) fn is_strength(word: &str) -> bool {
    matches!(
        word,
        "strong0"
            | "strong1"
            | "pull0"
            | "pull1"
            | "weak0"
            | "weak1"
            | "highz0"
            | "highz1"
            | "supply0"
            | "supply1"
            | "small"
            | "medium"
            | "large"
    )
}

/// Keywords of Verilog-2005 (IEEE 1364-2005, annex B), none of which can be a name.
pub(super) fn is_keyword(word: &str) -> bool {
    KEYWORDS.binary_search(&word).is_ok()
}

const KEYWORDS: [&str; 124] = [
    "always",
    "and",
    "assign",
    "automatic",
    "begin",
    "buf",
    "bufif0",
    "bufif1",
    "case",
    "casex",
    "casez",
    "cell",
    "cmos",
    "config",
    "deassign",
    "default",
    "defparam",
    "design",
    "disable",
    "edge",
    "else",
    "end",
    "endcase",
    "endconfig",
    "endfunction",
    "endgenerate",
    "endmodule",
    "endprimitive",
    "endspecify",
    "endtable",
    "endtask",
    "event",
    "for",
    "force",
    "forever",
    "fork",
    "function",
    "generate",
    "genvar",
    "highz0",
    "highz1",
    "if",
    "ifnone",
    "incdir",
    "include",
    "initial",
    "inout",
    "input",
    "instance",
    "integer",
    "join",
    "large",
    "liblist",
    "library",
    "localparam",
    "macromodule",
    "medium",
    "module",
    "nand",
    "negedge",
    "nmos",
    "nor",
    "noshowcancelled",
    "not",
    "notif0",
    "notif1",
    "or",
    "output",
    "parameter",
    "pmos",
    "posedge",
    "primitive",
    "pull0",
    "pull1",
    "pulldown",
    "pullup",
    "pulsestyle_ondetect",
    "pulsestyle_onevent",
    "rcmos",
    "real",
    "realtime",
    "reg",
    "release",
    "repeat",
    "rnmos",
    "rpmos",
    "rtran",
    "rtranif0",
    "rtranif1",
    "scalared",
    "showcancelled",
    "signed",
    "small",
    "specify",
    "specparam",
    "strong0",
    "strong1",
    "supply0",
    "supply1",
    "table",
    "task",
    "time",
    "tran",
    "tranif0",
    "tranif1",
    "tri",
    "tri0",
    "tri1",
    "triand",
    "trior",
    "trireg",
    "unsigned",
    "use",
    "uwire",
    "vectored",
    "wait",
    "wand",
    "weak0",
    "weak1",
    "while",
    "wire",
    "wor",
    "xnor",
    "xor",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_keywords_are_sorted_so_that_each_is_found() {
        assert!(KEYWORDS.is_sorted());
        assert!(KEYWORDS.iter().all(|word| is_keyword(word)));
    }
}
