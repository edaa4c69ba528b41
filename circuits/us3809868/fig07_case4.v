// FIG. 7 of US 3,809,868: data converter for case IV, three points and the slope at the middle one.
//
//   A = X1 - X0   B = Y1 - Y0   C = X3 - X0   D = Y3 - Y0   H = X3 - X1   I = Y3 - Y1
//   G = (S3 C - D) / (S3 H - I)   E = (1 + G (sqrt(2 G) - 1)) / (1 + G^2)   F = sqrt(1 - E^2)
//   J = (C - A F) / (E + F - 1)   K = J + A   L = (D - B F) / (E + F - 1)   M = L + B     (E is the cosine at P3)
//
// Errata: the text applies 226 to the denominator and 210 to the numerator of divider 230, which is upside down; claim 8
// prints A = X1 - Y0 and (S3) H - 1 for X1 - X0 and S3 H - I.
//
// Words (sign included . fraction bits): coordinates 16.0; A..I 17.0; slope 32.18; 174, 176 49.18; 178, 180 50.18;
// G 41.28, so below 4096 (P3 no nearer to P1 than t = pi/2 - 0.022); 2 G 43.28; its root 35.28 without sign; 194 37.28;
// 186 48.28; G^2 53.28; 198 49.28; 202 54.28; E 31.30; F 30.30 without sign; 208, 212 61.60; 210 32.30; 220, 222 48.30;
// 224, 226 49.30; J and L, before rounding, 40.24; J..M 16.0.
// `error`: G <= 0 (a G below 2^-28 counts as 0), G >= 4096, S3 H = I; E outside 0 < E < 1; E + F = 1; J, K, L or M beyond
// 16 bits.
//
// Ranks: {162..172} {174, 176} {178, 180} {182} {184, 188} {192, 202} {194} {186} {198} {206} {208} {212} {216}
// {210, 220, 222} {224, 226} {228, 230} {rounder_228, rounder_230} {232, 234} {output registers}; 182 takes 40 ticks,
// 192 35, 206 and 216 30, 228 and 230 39.
// What is chosen for all five converters stands in converter_outputs.v.
`default_nettype none

module fig07_case4 (
    input  wire clk,
    input  wire start,
    input  wire signed [15:0] x0,
    input  wire signed [15:0] y0,
    input  wire signed [15:0] x1,
    input  wire signed [15:0] y1,
    input  wire signed [15:0] x3,
    input  wire signed [15:0] y3,
    (* fraction = 18 *) input wire signed [31:0] s3,
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
    wire [18:0] rank;

    // Sources.
    wire signed [15:0] held_x0, held_y0, held_x1, held_y1, held_x3, held_y3;
    converter_points sources (
        .clk(clk), .load(load), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x_third(x3), .y_third(y3),
        .held_x0(held_x0), .held_y0(held_y0), .held_x1(held_x1), .held_y1(held_y1), .held_x_third(held_x3),
        .held_y_third(held_y3)
    );
    (* fraction = 18 *) wire signed [31:0] held_s3;
    register #(.WIDTH(32)) source_s3 (.clk(clk), .word(s3), .enable(load), .clear(1'b0), .q(held_s3));
    assign x0_out = held_x0;
    assign y0_out = held_y0;

    // Rank 0
    wire signed [16:0] a_162;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_162 (
        .clk(clk), .strobe(rank[0]), .a(held_x1), .b(held_x0), .sum(a_162)
    );
    wire signed [16:0] b_164;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_164 (
        .clk(clk), .strobe(rank[0]), .a(held_y1), .b(held_y0), .sum(b_164)
    );
    wire signed [16:0] c_166;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_166 (
        .clk(clk), .strobe(rank[0]), .a(held_x3), .b(held_x0), .sum(c_166)
    );
    wire signed [16:0] d_168;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_168 (
        .clk(clk), .strobe(rank[0]), .a(held_y3), .b(held_y0), .sum(d_168)
    );
    wire signed [16:0] h_170;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_170 (
        .clk(clk), .strobe(rank[0]), .a(held_x3), .b(held_x1), .sum(h_170)
    );
    wire signed [16:0] i_172;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_172 (
        .clk(clk), .strobe(rank[0]), .a(held_y3), .b(held_y1), .sum(i_172)
    );

    // Ranks 1 to 3: G. A zero denominator (the tangent at P3 passes through P1) is an overflow, too.
    (* fraction = 18 *) wire signed [48:0] product_174;
    multiplier #(.A_WIDTH(17), .B_WIDTH(32), .WIDTH(49)) multiplier_174 (
        .clk(clk), .strobe(rank[1]), .a(c_166), .b(held_s3), .product(product_174)
    );
    (* fraction = 18 *) wire signed [48:0] product_176;
    multiplier #(.A_WIDTH(17), .B_WIDTH(32), .WIDTH(49)) multiplier_176 (
        .clk(clk), .strobe(rank[1]), .a(h_170), .b(held_s3), .product(product_176)
    );
    (* fraction = 18 *) wire signed [49:0] numerator_178;
    summer #(.A_WIDTH(49), .B_WIDTH(35), .WIDTH(50), .NEGATIVE(2'b10)) summer_178 (
        .clk(clk), .strobe(rank[2]), .a(product_174), .b({d_168, 18'd0}), .sum(numerator_178)
    );
    (* fraction = 18 *) wire signed [49:0] denominator_180;
    summer #(.A_WIDTH(49), .B_WIDTH(35), .WIDTH(50), .NEGATIVE(2'b10)) summer_180 (
        .clk(clk), .strobe(rank[2]), .a(product_176), .b({i_172, 18'd0}), .sum(denominator_180)
    );
    (* fraction = 28 *) wire signed [40:0] g_182;
    wire ready_182;
    wire degenerate_182;
    wire overflow_182;
    divider #(.NUMERATOR_WIDTH(50), .DENOMINATOR_WIDTH(50), .FRACTION(28), .WIDTH(41)) divider_182 (
        .clk(clk), .start(rank[3]), .numerator(numerator_178), .denominator(denominator_180), .quotient(g_182),
        .ready(ready_182), .zero_denominator(degenerate_182), .overflow(overflow_182)
    );

    // Ranks 4 to 8. A negative G shows at 192, G = 0 as E = 1 at 206.
    wire signed [2:0] two_190;
    reference #(.WIDTH(3), .VALUE(2)) reference_190 (.value(two_190));
    (* fraction = 28 *) wire signed [42:0] radicand_184;
    multiplier #(.A_WIDTH(41), .B_WIDTH(3), .WIDTH(43)) multiplier_184 (
        .clk(clk), .strobe(rank[4]), .a(g_182), .b(two_190), .product(radicand_184)
    );
    (* fraction = 28 *) wire signed [52:0] square_188;
    squaring_circuit #(.A_WIDTH(41), .DROP(28), .WIDTH(53)) squaring_circuit_188 (
        .clk(clk), .strobe(rank[4]), .a(g_182), .square(square_188)
    );
    (* fraction = 28 *) wire [34:0] root_192;
    wire ready_192;
    wire negative_192;
    square_rooter #(.PAIRS(21), .EXTRA(14)) square_rooter_192 (
        .clk(clk), .start(rank[5]), .radicand(radicand_184), .root(root_192), .ready(ready_192),
        .negative(negative_192)
    );
    wire signed [1:0] one_204;
    reference #(.WIDTH(2), .VALUE(1)) reference_204 (.value(one_204));
    (* fraction = 28 *) wire signed [53:0] denominator_202;
    summer #(.A_WIDTH(53), .B_WIDTH(30), .WIDTH(54)) summer_202 (
        .clk(clk), .strobe(rank[5]), .a(square_188), .b({one_204, 28'd0}), .sum(denominator_202)
    );
    wire signed [1:0] one_196;
    reference #(.WIDTH(2), .VALUE(1)) reference_196 (.value(one_196));
    (* fraction = 28 *) wire signed [36:0] difference_194;
    summer #(.A_WIDTH(36), .B_WIDTH(30), .WIDTH(37), .NEGATIVE(2'b10)) summer_194 (
        .clk(clk), .strobe(rank[6]), .a({1'b0, root_192}), .b({one_196, 28'd0}), .sum(difference_194)
    );
    (* fraction = 28 *) wire signed [47:0] product_186;
    multiplier #(.A_WIDTH(41), .B_WIDTH(37), .DROP(28), .WIDTH(48)) multiplier_186 (
        .clk(clk), .strobe(rank[7]), .a(g_182), .b(difference_194), .product(product_186)
    );
    wire signed [1:0] one_200;
    reference #(.WIDTH(2), .VALUE(1)) reference_200 (.value(one_200));
    (* fraction = 28 *) wire signed [48:0] numerator_198;
    summer #(.A_WIDTH(48), .B_WIDTH(30), .WIDTH(49)) summer_198 (
        .clk(clk), .strobe(rank[8]), .a(product_186), .b({one_200, 28'd0}), .sum(numerator_198)
    );

    // Ranks 9 to 13: E, and F = sqrt(1 - E^2). E >= 1 overflows 206; 1 - E^2 = 1 (E = 0) overflows 212.
    (* fraction = 30 *) wire signed [30:0] e_206;
    wire ready_206;
    wire overflow_206;
    divider #(.NUMERATOR_WIDTH(49), .DENOMINATOR_WIDTH(54), .FRACTION(30), .WIDTH(31)) divider_206 (
        .clk(clk), .start(rank[9]), .numerator(numerator_198), .denominator(denominator_202), .quotient(e_206),
        .ready(ready_206), .overflow(overflow_206)
    );
    (* fraction = 60 *) wire signed [60:0] square_208;
    squaring_circuit #(.A_WIDTH(31), .WIDTH(61)) squaring_circuit_208 (
        .clk(clk), .strobe(rank[10]), .a(e_206), .square(square_208)
    );
    wire signed [1:0] one_214;
    reference #(.WIDTH(2), .VALUE(1)) reference_214 (.value(one_214));
    (* fraction = 60 *) wire signed [60:0] radicand_212;
    wire overflow_212;
    summer #(.A_WIDTH(62), .B_WIDTH(61), .WIDTH(61), .NEGATIVE(2'b10)) summer_212 (
        .clk(clk), .strobe(rank[11]), .a({one_214, 60'd0}), .b(square_208), .sum(radicand_212),
        .overflow(overflow_212)
    );
    (* fraction = 30 *) wire [29:0] f_216;
    wire ready_216;
    square_rooter #(.PAIRS(30)) square_rooter_216 (
        .clk(clk), .start(rank[12]), .radicand(radicand_212), .root(f_216), .ready(ready_216)
    );
    wire signed [1:0] minus_one_218;
    reference #(.WIDTH(2), .VALUE(-1)) reference_218 (.value(minus_one_218));
    (* fraction = 30 *) wire signed [31:0] denominator_210;
    summer_3 #(.A_WIDTH(31), .B_WIDTH(32), .C_WIDTH(31), .WIDTH(32)) summer_210 (
        .clk(clk), .strobe(rank[13]), .a({1'b0, f_216}), .b({minus_one_218, 30'd0}), .c(e_206), .sum(denominator_210)
    );

    // Ranks 13 to 17: J, L and their partners.
    (* fraction = 30 *) wire signed [47:0] product_220;
    multiplier #(.A_WIDTH(31), .B_WIDTH(17), .WIDTH(48)) multiplier_220 (
        .clk(clk), .strobe(rank[13]), .a({1'b0, f_216}), .b(a_162), .product(product_220)
    );
    (* fraction = 30 *) wire signed [47:0] product_222;
    multiplier #(.A_WIDTH(31), .B_WIDTH(17), .WIDTH(48)) multiplier_222 (
        .clk(clk), .strobe(rank[13]), .a({1'b0, f_216}), .b(b_164), .product(product_222)
    );
    (* fraction = 30 *) wire signed [48:0] numerator_224;
    summer #(.A_WIDTH(47), .B_WIDTH(48), .WIDTH(49), .NEGATIVE(2'b10)) summer_224 (
        .clk(clk), .strobe(rank[14]), .a({c_166, 30'd0}), .b(product_220), .sum(numerator_224)
    );
    (* fraction = 30 *) wire signed [48:0] numerator_226;
    summer #(.A_WIDTH(47), .B_WIDTH(48), .WIDTH(49), .NEGATIVE(2'b10)) summer_226 (
        .clk(clk), .strobe(rank[14]), .a({d_168, 30'd0}), .b(product_222), .sum(numerator_226)
    );
    (* fraction = 24 *) wire signed [39:0] j_228;
    wire ready_228;
    wire overflow_228;
    divider #(.NUMERATOR_WIDTH(49), .DENOMINATOR_WIDTH(32), .FRACTION(24), .WIDTH(40)) divider_228 (
        .clk(clk), .start(rank[15]), .numerator(numerator_224), .denominator(denominator_210), .quotient(j_228),
        .ready(ready_228), .overflow(overflow_228)
    );
    (* fraction = 24 *) wire signed [39:0] l_230;
    wire ready_230;
    wire overflow_230;
    divider #(.NUMERATOR_WIDTH(49), .DENOMINATOR_WIDTH(32), .FRACTION(24), .WIDTH(40)) divider_230 (
        .clk(clk), .start(rank[15]), .numerator(numerator_226), .denominator(denominator_210), .quotient(l_230),
        .ready(ready_230), .overflow(overflow_230)
    );
    wire signed [15:0] j_rounded;
    wire overflow_rounder_228;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_228 (
        .clk(clk), .strobe(rank[16]), .a(j_228), .rounded(j_rounded), .overflow(overflow_rounder_228)
    );
    wire signed [15:0] l_rounded;
    wire overflow_rounder_230;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_230 (
        .clk(clk), .strobe(rank[16]), .a(l_230), .rounded(l_rounded), .overflow(overflow_rounder_230)
    );
    wire signed [15:0] k_232;
    wire overflow_232;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_232 (
        .clk(clk), .strobe(rank[17]), .a(j_rounded), .b(a_162), .sum(k_232), .overflow(overflow_232)
    );
    wire signed [15:0] m_234;
    wire overflow_234;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_234 (
        .clk(clk), .strobe(rank[17]), .a(l_rounded), .b(b_164), .sum(m_234), .overflow(overflow_234)
    );

    // What can go wrong: each flag is held by its module until the next conversion.
    wire wrong;
    or or_wrong (wrong, overflow_182, negative_192, overflow_206, overflow_212, overflow_228, overflow_230,
        overflow_rounder_228, overflow_rounder_230, overflow_232, overflow_234);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[18]), .wrong(wrong), .j_word(j_rounded), .k_word(k_232),
        .l_word(l_rounded), .m_word(m_234), .j(j), .k(k), .l(l), .m(m), .error(error)
    );

    // The rank sequencer: a rank is clocked when no digit-by-digit unit is at work.
    wire ready;
    and and_ready (ready, ready_182, ready_192, ready_206, ready_216, ready_228, ready_230);
    rank_sequencer #(.RANKS(19)) rank_sequencer (
        .clk(clk), .start(start), .ready(ready), .load(load), .rank(rank), .done(done)
    );
endmodule
