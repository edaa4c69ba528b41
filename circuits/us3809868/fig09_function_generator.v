`default_nettype none

// Function generator 16 of US 3,809,868, FIG. 9 (with the generators and the time control of FIG. 10 inside):
// half a clock is two ticks, and nothing holds the clock. A stroke of q quarters keeps `busy` high for q * 32768 ticks.
//
// All blocks stand in module incremental_generator, which FIG. 10 uses, too: descend into generator_16. Its file says
// how the circuit works, what is from the text and what is chosen, and when `error` goes high:
// - coefficient of more than 4095 (2^(WIDTH-GUARD) - 1) in magnitude, `quarters` 0 or more than 4, start while busy:
//   the start is refused, X and Y stay, a stroke under way goes on unharmed;
// - X or Y carried beyond 16 bits.
// It stays high until the next start that is accepted.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3 *)
module fig09_function_generator #(
    parameter WIDTH = 12,       // bits of the multipliers
    parameter ENTRIES = 128,    // words of the tables
    parameter ENTRY_WIDTH = 6,  // bits of these words
    parameter GUARD = 0         // guard stages below the counters, 0 to 3
) (
    input wire clk,
    input wire start,               // one tick, with all other inputs
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire [2:0] quarters,      // 1 to 4
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire busy,
    output wire done,               // one tick after the end
    output wire error
);
    incremental_generator #(
        .WIDTH(WIDTH),
        .ENTRIES(ENTRIES),
        .ENTRY_WIDTH(ENTRY_WIDTH),
        .GUARD(GUARD)
    ) generator_16 (
        .clk(clk),
        .start(start),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x0(x0),
        .y0(y0),
        .quarters(quarters),
        .hold(1'b0),
        .inhibit(1'b0),
        .fast(1'b0),
        .x(x),
        .y(y),
        .up_304(up_304),
        .down_306(down_306),
        .up_314(up_314),
        .down_316(down_316),
        .pulse_290(),
        .pulse_292(),
        .started(),
        .busy(busy),
        .done(done),
        .error(error)
    );
endmodule
