// The end of the data converters, FIG. 3 and 5 to 8 of US 3,809,868, and of the transformations, FIG. 12, 14 and 20:
// registers that take J, K, L and M in the last rank, or are cleared when anything is wrong.
//
// Chosen for all five converters, where the patent is silent:
//  - each numbered module is clocked: it takes its inputs at the strobe of its rank and holds its output;
//  - the sources are registers, loaded in the tick of `start`;
//  - one of (J, K) and one of (L, M) is rounded to a whole count, a half upwards (rounder_*), and its partner is formed
//    through the exact whole number A or B: K - J = A and M - L = B always, and the drawn end is exactly (X1, Y1);
//  - `done` rises when the result stands, and stays until the next start; `error` goes with it, and J..M are then 0.
`default_nettype none

module converter_outputs (
    input wire clk,
    input wire load,                 // a conversion begins
    input wire finish,               // its last rank
    input wire wrong,                // it has no result
    input wire signed [15:0] j_word,
    input wire signed [15:0] k_word,
    input wire signed [15:0] l_word,
    input wire signed [15:0] m_word,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire error
);
    wire refuse;
    and and_refuse (refuse, finish, wrong);
    register #(.WIDTH(16)) register_j (.clk(clk), .word(j_word), .enable(finish), .clear(refuse), .q(j));
    register #(.WIDTH(16)) register_k (.clk(clk), .word(k_word), .enable(finish), .clear(refuse), .q(k));
    register #(.WIDTH(16)) register_l (.clk(clk), .word(l_word), .enable(finish), .clear(refuse), .q(l));
    register #(.WIDTH(16)) register_m (.clk(clk), .word(m_word), .enable(finish), .clear(refuse), .q(m));
    register #(.WIDTH(1)) register_error (.clk(clk), .word(wrong), .enable(finish), .clear(load), .q(error));
endmodule
