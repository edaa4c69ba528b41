//! Export: Verilog of the blocks and a bench for outside simulators.
