// FIG. 5 of US 3,809,868: data converter for case II, three points and the first slope.
//
//   A = X1 - X0   B = Y1 - Y0   C = X1 - X3   D = Y1 - Y3   E = (S0 C - D) / (S0 A - B)   F = sqrt(1 - E^2)
//   K = (A E - C) / (E + F - 1)   J = K - A   M = S0 K   L = M - B          (E is the cosine at P3, F the sine)
//
// Errata: the printed formula and claim 6 have S1 in the denominator of E; the figure multiplies by S0 (136), which is
// right. The inputs of summer 108 are not stated; they are 106 and, inverted, 138.
//
// Words (sign included . fraction bits): coordinates 16.0; A..D 17.0; slope 32.18; 136, 140 49.18; 132, 134 50.18;
// E 31.30; F 30.30 without sign; 124, 122 61.60; 114 32.30; 128 48.30; 112 49.30; K and M, before rounding, 40.24;
// J..M 16.0.
// `error`: E outside 0 < E < 1 (an E below 2^-30 counts as 0); S0 A = B; E + F = 1; J, K, L or M beyond 16 bits.
//
// Ranks: {110, 138, 130, 142} {136, 140} {132, 134} {120} {124, 128} {122, 112} {116} {114} {104} {rounder_104, 106}
// {102, rounder_106} {108} {output registers}; 120 and 116 take 30 ticks, 104 takes 39.
// What is chosen for all five converters stands in converter_outputs.v.
`default_nettype none

module fig05_case2 (
    input  wire clk,
    input  wire start,
    input  wire signed [15:0] x0,
    input  wire signed [15:0] y0,
    input  wire signed [15:0] x1,
    input  wire signed [15:0] y1,
    input  wire signed [15:0] x3,
    input  wire signed [15:0] y3,
    (* fraction = 18 *) input wire signed [31:0] s0,
    output wire signed [15:0] x0_out,
    output wire signed [15:0] y0_out,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire done,
    output wire error
);
    wire load;
    wire [12:0] rank;

    // Sources.
    wire signed [15:0] held_x0, held_y0, held_x1, held_y1, held_x3, held_y3;
    converter_points sources (
        .clk(clk), .load(load), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x_third(x3), .y_third(y3),
        .held_x0(held_x0), .held_y0(held_y0), .held_x1(held_x1), .held_y1(held_y1), .held_x_third(held_x3),
        .held_y_third(held_y3)
    );
    (* fraction = 18 *) wire signed [31:0] held_s0;
    register #(.WIDTH(32)) source_s0 (.clk(clk), .word(s0), .enable(load), .clear(1'b0), .q(held_s0));
    assign x0_out = held_x0;
    assign y0_out = held_y0;

    // Rank 0
    wire signed [16:0] c_130;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_130 (
        .clk(clk), .strobe(rank[0]), .a(held_x1), .b(held_x3), .sum(c_130)
    );
    wire signed [16:0] d_142;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_142 (
        .clk(clk), .strobe(rank[0]), .a(held_y1), .b(held_y3), .sum(d_142)
    );

    // A and B, E, F and E + F - 1: ranks 0 to 7.
    wire signed [16:0] a_110;
    wire signed [16:0] b_138;
    (* fraction = 30 *) wire signed [30:0] e_120;
    (* fraction = 30 *) wire [29:0] f_116;
    (* fraction = 30 *) wire signed [31:0] denominator_114;
    wire ready_e_and_f;
    wire wrong_e_and_f;
    converter_e_and_f e_and_f (
        .clk(clk), .rank(rank[7:0]), .x0(held_x0), .y0(held_y0), .x1(held_x1), .y1(held_y1), .c(c_130), .d(d_142),
        .slope(held_s0), .a_110(a_110), .b_138(b_138), .e_120(e_120), .f_116(f_116),
        .denominator_114(denominator_114), .ready(ready_e_and_f), .wrong(wrong_e_and_f)
    );

    // K
    (* fraction = 30 *) wire signed [47:0] product_128;
    multiplier #(.A_WIDTH(31), .B_WIDTH(17), .WIDTH(48)) multiplier_128 (
        .clk(clk), .strobe(rank[4]), .a(e_120), .b(a_110), .product(product_128)
    );
    (* fraction = 30 *) wire signed [48:0] numerator_112;
    summer #(.A_WIDTH(48), .B_WIDTH(47), .WIDTH(49), .NEGATIVE(2'b10)) summer_112 (
        .clk(clk), .strobe(rank[5]), .a(product_128), .b({c_130, 30'd0}), .sum(numerator_112)
    );
    (* fraction = 24 *) wire signed [39:0] k_104;
    wire ready_104;
    wire overflow_104;
    divider #(.NUMERATOR_WIDTH(49), .DENOMINATOR_WIDTH(32), .FRACTION(24), .WIDTH(40)) divider_104 (
        .clk(clk), .start(rank[8]), .numerator(numerator_112), .denominator(denominator_114), .quotient(k_104),
        .ready(ready_104), .overflow(overflow_104)
    );
    wire signed [15:0] k_rounded;
    wire overflow_rounder_104;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_104 (
        .clk(clk), .strobe(rank[9]), .a(k_104), .rounded(k_rounded), .overflow(overflow_rounder_104)
    );

    // M, J, L
    (* fraction = 24 *) wire signed [39:0] m_106;
    wire overflow_106;
    multiplier #(.A_WIDTH(40), .B_WIDTH(32), .DROP(18), .WIDTH(40)) multiplier_106 (
        .clk(clk), .strobe(rank[9]), .a(k_104), .b(held_s0), .product(m_106), .overflow(overflow_106)
    );
    wire signed [15:0] j_102;
    wire overflow_102;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16), .NEGATIVE(2'b10)) summer_102 (
        .clk(clk), .strobe(rank[10]), .a(k_rounded), .b(a_110), .sum(j_102), .overflow(overflow_102)
    );
    wire signed [15:0] m_rounded;
    wire overflow_rounder_106;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_106 (
        .clk(clk), .strobe(rank[10]), .a(m_106), .rounded(m_rounded), .overflow(overflow_rounder_106)
    );
    wire signed [15:0] l_108;
    wire overflow_108;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16), .NEGATIVE(2'b10)) summer_108 (
        .clk(clk), .strobe(rank[11]), .a(m_rounded), .b(b_138), .sum(l_108), .overflow(overflow_108)
    );

    // What can go wrong: each flag is held by its module until the next conversion.
    wire wrong;
    or or_wrong (wrong, wrong_e_and_f, overflow_104, overflow_rounder_104, overflow_106,
        overflow_102, overflow_rounder_106, overflow_108);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[12]), .wrong(wrong), .j_word(j_102), .k_word(k_rounded),
        .l_word(l_108), .m_word(m_rounded), .j(j), .k(k), .l(l), .m(m), .error(error)
    );

    // The rank sequencer: a rank is clocked when no digit-by-digit unit is at work.
    wire ready;
    and and_ready (ready, ready_e_and_f, ready_104);
    rank_sequencer #(.RANKS(13)) rank_sequencer (
        .clk(clk), .start(start), .ready(ready), .load(load), .rank(rank), .done(done)
    );
endmodule
