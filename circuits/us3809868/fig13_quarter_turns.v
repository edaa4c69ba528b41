// FIG. 13 of US 3,809,868: quarter turns and reflections, from the coefficients and their negatives alone.
//
// Matrix 440 connects each output to a coefficient or to its negative (442 to 448). Each of eight controls closes
// four of its switches; 464 passes all through. What a control does to a point (x, y) of the stroke, seen from its
// initial point:
//
//   450 (-y,  x) quarter turn counter-clockwise      J' K' L' M' = -L -M  J  K
//   452 (-x, -y) half turn                                         -J -K -L -M
//   454 ( y, -x) quarter turn clockwise                             L  M -J -K
//   456 (-x,  y) left and right exchanged                          -J -K  L  M
//   458 ( x, -y) up and down exchanged                              J  K -L -M
//   460 ( y,  x) reflected in y = x                                 L  M  J  K
//   462 (-y, -x) reflected in y = -x                               -L -M -J -K
//   464 ( x,  y) as it is                                           J  K  L  M
//
// Errata: the printed "eighth control 364" is 464. The table of FIG. 13A, the letter P in eight positions, is lost.
// That these are the eight is forced, they are the symmetries of the square; which of 450 to 462 does which is chosen.
//
// Combinational: nothing is clocked. Words: J..M 16 bits, within the circuit 17, as -32768 has a negative of 17 bits.
// `error` (chosen): not just one control is 1, or a result beyond 16 bits. J'..M' are then 0.
`default_nettype none

module fig13_quarter_turns (
    input wire control_450,
    input wire control_452,
    input wire control_454,
    input wire control_456,
    input wire control_458,
    input wire control_460,
    input wire control_462,
    input wire control_464,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    output wire signed [15:0] j_out,
    output wire signed [15:0] k_out,
    output wire signed [15:0] l_out,
    output wire signed [15:0] m_out,
    output wire error
);
    // The negating circuits, in the order of the text.
    wire signed [16:0] minus_j_442;
    negator #(.WIDTH(16)) negator_442 (.word(j), .negative(minus_j_442));
    wire signed [16:0] minus_l_444;
    negator #(.WIDTH(16)) negator_444 (.word(l), .negative(minus_l_444));
    wire signed [16:0] minus_k_446;
    negator #(.WIDTH(16)) negator_446 (.word(k), .negative(minus_k_446));
    wire signed [16:0] minus_m_448;
    negator #(.WIDTH(16)) negator_448 (.word(m), .negative(minus_m_448));

    wire signed [16:0] j_440;
    wire signed [16:0] k_440;
    wire signed [16:0] l_440;
    wire signed [16:0] m_440;
    wire single;
    switch_matrix #(.WIDTH(17)) matrix_440 (
        .controls({
            control_464, control_462, control_460, control_458, control_456, control_454, control_452, control_450
        }),
        .j({j[15], j}),
        .k({k[15], k}),
        .l({l[15], l}),
        .m({m[15], m}),
        .minus_j(minus_j_442),
        .minus_k(minus_k_446),
        .minus_l(minus_l_444),
        .minus_m(minus_m_448),
        .j_out(j_440),
        .k_out(k_440),
        .l_out(l_440),
        .m_out(m_440),
        .single(single)
    );

    // A word fits 16 bits when its two top bits are equal.
    wire beyond_j;
    wire beyond_k;
    wire beyond_l;
    wire beyond_m;
    wire several_or_none;
    wire good;
    xor xor_beyond_j (beyond_j, j_440[16], j_440[15]);
    xor xor_beyond_k (beyond_k, k_440[16], k_440[15]);
    xor xor_beyond_l (beyond_l, l_440[16], l_440[15]);
    xor xor_beyond_m (beyond_m, m_440[16], m_440[15]);
    not not_single (several_or_none, single);
    or or_error (error, several_or_none, beyond_j, beyond_k, beyond_l, beyond_m);
    not not_error (good, error);
    word_gate #(.WIDTH(16)) gate_j (.open(good), .word(j_440[15:0]), .passed(j_out));
    word_gate #(.WIDTH(16)) gate_k (.open(good), .word(k_440[15:0]), .passed(k_out));
    word_gate #(.WIDTH(16)) gate_l (.open(good), .word(l_440[15:0]), .passed(l_out));
    word_gate #(.WIDTH(16)) gate_m (.open(good), .word(m_440[15:0]), .passed(m_out));
endmodule
