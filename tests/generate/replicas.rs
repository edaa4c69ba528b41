//! Random circuits of several instances of one random module, wired to each other.

use proptest::prelude::*;
use stepwright::base::{Graph, Op, Signal, ValueId};
use stepwright::compile::{Owner, OwnerId, Program};

use super::graphs::{Recipe, grow, recipes_of};

/// Instances of one module.
#[derive(Clone, Debug)]
pub struct Replicas {
    /// The module.
    pub recipe: Recipe,
    /// For each instance, what its inputs are wired to, as far as that makes no loop.
    pub wiring: Vec<Vec<u16>>,
}

/// Two to six instances of a module of so many ops.
pub fn replicas(ops: std::ops::Range<usize>) -> impl Strategy<Value = Replicas> {
    let wiring = prop::collection::vec(prop::collection::vec(any::<u16>(), 4), 2..6);
    (recipes_of(ops), wiring).prop_map(|(recipe, wiring)| Replicas { recipe, wiring })
}

/// The program; its ops stand in any order.
pub fn replicate(replicas: &Replicas) -> Program {
    let module = grow(&replicas.recipe);
    let mut whole =
        Program { signals: Vec::new(), stop: None, graph: Graph::default(), owner: Vec::new(), ..module.clone() };
    let inputs: Vec<_> =
        module.inputs.iter().zip(0..).map(|(port, i)| whole.graph.push(Op::Input(i), port.width)).collect();
    whole.owner.resize(whole.graph.nodes.len(), OwnerId::new(0));
    for copy in 0..replicas.wiring.len() {
        let place = whole.graph.append(&module.graph, &inputs);
        whole.owners.push(Owner { parent: Some(OwnerId::new(0)), module: "module".into() });
        whole.owner.resize(whole.graph.nodes.len(), OwnerId::new(copy + 1));
        whole.signals.extend(module.signals.iter().map(|signal| Signal {
            path: vec!["top".into(), format!("copy{copy}"), signal.path[1].clone()],
            value: place(signal.value),
            ..signal.clone()
        }));
        whole.stop = module.stop.map(place);
    }
    let size = module.graph.nodes.len();
    for (copy, wires) in replicas.wiring.iter().enumerate() {
        for (input, &choice) in (0..inputs.len()).zip(wires) {
            let wire = ValueId::new(inputs.len() + copy * size + input);
            connect(&mut whole.graph, wire, choice);
        }
    }
    whole
}

/// Connects a wire to some value of its width, unless that depends on the wire.
fn connect(graph: &mut Graph, wire: ValueId, choice: u16) {
    let fitting: Vec<_> =
        (0..graph.nodes.len()).map(ValueId::new).filter(|&id| graph.width(id) == graph.width(wire)).collect();
    let chosen = fitting[usize::from(choice) % fitting.len()];
    if !depends(graph, chosen, wire) {
        graph.nodes[wire.index()].op = Op::Copy(chosen);
    }
}

fn depends(graph: &Graph, value: ValueId, on: ValueId) -> bool {
    let mut open = vec![value];
    let mut seen = vec![false; graph.nodes.len()];
    while let Some(id) = open.pop() {
        if id == on {
            return true;
        }
        if !std::mem::replace(&mut seen[id.index()], true) {
            graph.node(id).op.operands(|operand| open.push(operand));
        }
    }
    false
}
