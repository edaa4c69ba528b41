// FIG. 6 of US 3,809,868: data converter for case III, three points and the last slope.
//
//   A = X1 - X0   B = Y1 - Y0   C = X3 - X0   D = Y3 - Y0   E = (S1 C - D) / (S1 A - B)   F = sqrt(1 - E^2)
//   K = ((X3 - X1) + A F) / (E + F - 1)   J = K - A   L = S1 J   M = L + B     (E is the sine at P3, F the cosine)
//
// The text gives this figure as differences to FIG. 5, from which 110..126 and 132..138 are taken over.
// Errata: "inverter" is the converter; claim 7 prints M = L - B; the polarities of summer 160 are not stated: both plus.
// That 140 takes 144 and 134 inverts 146 is implied.
//
// Words (sign included . fraction bits): coordinates 16.0; A..D 17.0; slope 32.18; 136, 140 49.18; 132, 134 50.18;
// E 31.30; F 30.30 without sign; 124, 122 61.60; 114 32.30; 148 18.0; 150 48.30; 152 49.30; K, J and L, before rounding,
// 40.24; J..M 16.0.
// `error`: E outside 0 < E < 1 (an E below 2^-30 counts as 0); S1 A = B; E + F = 1; J, K, L or M beyond 16 bits.
//
// Ranks: {110, 138, 144, 146} {136, 140, 148} {132, 134} {120} {124} {122} {116} {114, 150} {152} {154}
// {156, rounder_154} {158, rounder_156} {rounder_158} {160} {output registers}; 120 and 116 take 30 ticks, 154 takes 39.
// What is chosen for all five converters stands in converter_outputs.v.
`default_nettype none

module fig06_case3 (
    input  wire clk,
    input  wire start,
    input  wire signed [15:0] x0,
    input  wire signed [15:0] y0,
    input  wire signed [15:0] x1,
    input  wire signed [15:0] y1,
    input  wire signed [15:0] x3,
    input  wire signed [15:0] y3,
    (* fraction = 18 *) input wire signed [31:0] s1,
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
    wire [14:0] rank;

    // Sources.
    wire signed [15:0] held_x0, held_y0, held_x1, held_y1, held_x3, held_y3;
    converter_points sources (
        .clk(clk), .load(load), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x_third(x3), .y_third(y3),
        .held_x0(held_x0), .held_y0(held_y0), .held_x1(held_x1), .held_y1(held_y1), .held_x_third(held_x3),
        .held_y_third(held_y3)
    );
    (* fraction = 18 *) wire signed [31:0] held_s1;
    register #(.WIDTH(32)) source_s1 (.clk(clk), .word(s1), .enable(load), .clear(1'b0), .q(held_s1));
    assign x0_out = held_x0;
    assign y0_out = held_y0;

    // Rank 0
    wire signed [16:0] c_144;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_144 (
        .clk(clk), .strobe(rank[0]), .a(held_x3), .b(held_x0), .sum(c_144)
    );
    wire signed [16:0] d_146;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_146 (
        .clk(clk), .strobe(rank[0]), .a(held_y3), .b(held_y0), .sum(d_146)
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
        .clk(clk), .rank(rank[7:0]), .x0(held_x0), .y0(held_y0), .x1(held_x1), .y1(held_y1), .c(c_144), .d(d_146),
        .slope(held_s1), .a_110(a_110), .b_138(b_138), .e_120(e_120), .f_116(f_116),
        .denominator_114(denominator_114), .ready(ready_e_and_f), .wrong(wrong_e_and_f)
    );

    // K
    wire signed [17:0] difference_148;
    summer #(.A_WIDTH(17), .B_WIDTH(17), .WIDTH(18), .NEGATIVE(2'b10)) summer_148 (
        .clk(clk), .strobe(rank[1]), .a(c_144), .b(a_110), .sum(difference_148)
    );
    (* fraction = 30 *) wire signed [47:0] product_150;
    multiplier #(.A_WIDTH(17), .B_WIDTH(31), .WIDTH(48)) multiplier_150 (
        .clk(clk), .strobe(rank[7]), .a(a_110), .b({1'b0, f_116}), .product(product_150)
    );
    (* fraction = 30 *) wire signed [48:0] numerator_152;
    summer #(.A_WIDTH(48), .B_WIDTH(48), .WIDTH(49)) summer_152 (
        .clk(clk), .strobe(rank[8]), .a({difference_148, 30'd0}), .b(product_150), .sum(numerator_152)
    );
    (* fraction = 24 *) wire signed [39:0] k_154;
    wire ready_154;
    wire overflow_154;
    divider #(.NUMERATOR_WIDTH(49), .DENOMINATOR_WIDTH(32), .FRACTION(24), .WIDTH(40)) divider_154 (
        .clk(clk), .start(rank[9]), .numerator(numerator_152), .denominator(denominator_114), .quotient(k_154),
        .ready(ready_154), .overflow(overflow_154)
    );

    // J, L, M. L needs J before it is rounded, so 156 takes the exact A from the unrounded K; as rounding commutes
    // with whole numbers, the rounded J is the rounded K less A.
    wire signed [15:0] k_rounded;
    wire overflow_rounder_154;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_154 (
        .clk(clk), .strobe(rank[10]), .a(k_154), .rounded(k_rounded), .overflow(overflow_rounder_154)
    );
    (* fraction = 24 *) wire signed [39:0] j_156;
    wire overflow_156;
    summer #(.A_WIDTH(40), .B_WIDTH(41), .WIDTH(40), .NEGATIVE(2'b10)) summer_156 (
        .clk(clk), .strobe(rank[10]), .a(k_154), .b({a_110, 24'd0}), .sum(j_156), .overflow(overflow_156)
    );
    wire signed [15:0] j_rounded;
    wire overflow_rounder_156;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_156 (
        .clk(clk), .strobe(rank[11]), .a(j_156), .rounded(j_rounded), .overflow(overflow_rounder_156)
    );
    (* fraction = 24 *) wire signed [39:0] l_158;
    wire overflow_158;
    multiplier #(.A_WIDTH(40), .B_WIDTH(32), .DROP(18), .WIDTH(40)) multiplier_158 (
        .clk(clk), .strobe(rank[11]), .a(j_156), .b(held_s1), .product(l_158), .overflow(overflow_158)
    );
    wire signed [15:0] l_rounded;
    wire overflow_rounder_158;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_158 (
        .clk(clk), .strobe(rank[12]), .a(l_158), .rounded(l_rounded), .overflow(overflow_rounder_158)
    );
    wire signed [15:0] m_160;
    wire overflow_160;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_160 (
        .clk(clk), .strobe(rank[13]), .a(l_rounded), .b(b_138), .sum(m_160), .overflow(overflow_160)
    );

    // What can go wrong: each flag is held by its module until the next conversion.
    wire wrong;
    or or_wrong (wrong, wrong_e_and_f, overflow_154, overflow_rounder_154, overflow_156,
        overflow_rounder_156, overflow_158, overflow_rounder_158, overflow_160);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[14]), .wrong(wrong), .j_word(j_rounded), .k_word(k_rounded),
        .l_word(l_rounded), .m_word(m_160), .j(j), .k(k), .l(l), .m(m), .error(error)
    );

    // The rank sequencer: a rank is clocked when no digit-by-digit unit is at work.
    wire ready;
    and and_ready (ready, ready_e_and_f, ready_154);
    rank_sequencer #(.RANKS(15)) rank_sequencer (
        .clk(clk), .start(start), .ready(ready), .load(load), .rank(rank), .done(done)
    );
endmodule
