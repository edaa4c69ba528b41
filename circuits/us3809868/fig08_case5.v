// FIG. 8 of US 3,809,868: data converter for case V, two points and the point farthest from their chord.
//
//   A = X1 - X0   B = Y1 - Y0   C = X2 - X0   D = Y2 - Y0   R = 1 / sqrt 2   T = 1 / (sqrt 2 - 1)
//   J = (C - A R) T   K = J + A   L = (D - B R) T   M = L + B
//
// Errata: numeral 248 stands for the reference 1 / sqrt 2 and for a summer; both are kept, as reference_248 and
// summer_248. The printed K = J - A has lost a plus sign.
//
// Words (sign included . fraction bits): coordinates 16.0; A..D 17.0; R 31.30; T 33.30; 244, 246 48.30; 248, 250 49.30;
// J and L, before rounding, 40.24; J..M 16.0.
// `error`: J, K, L or M beyond 16 bits. No other input is singular.
//
// Ranks: {236..242} {244, 246} {248, 250} {252, 254} {rounder_252, rounder_254} {258, 260} {output registers}. There is
// no divider, so no rank waits.
// What is chosen for all five converters stands in converter_outputs.v.
`default_nettype none

module fig08_case5 (
    input  wire clk,
    input  wire start,
    input  wire signed [15:0] x0,
    input  wire signed [15:0] y0,
    input  wire signed [15:0] x1,
    input  wire signed [15:0] y1,
    input  wire signed [15:0] x2,
    input  wire signed [15:0] y2,
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
    wire [6:0] rank;

    // Sources.
    wire signed [15:0] held_x0, held_y0, held_x1, held_y1, held_x2, held_y2;
    converter_points sources (
        .clk(clk), .load(load), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x_third(x2), .y_third(y2),
        .held_x0(held_x0), .held_y0(held_y0), .held_x1(held_x1), .held_y1(held_y1), .held_x_third(held_x2),
        .held_y_third(held_y2)
    );
    assign x0_out = held_x0;
    assign y0_out = held_y0;

    // Rank 0
    wire signed [16:0] c_236;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_236 (
        .clk(clk), .strobe(rank[0]), .a(held_x2), .b(held_x0), .sum(c_236)
    );
    wire signed [16:0] a_238;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_238 (
        .clk(clk), .strobe(rank[0]), .a(held_x1), .b(held_x0), .sum(a_238)
    );
    wire signed [16:0] b_240;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_240 (
        .clk(clk), .strobe(rank[0]), .a(held_y1), .b(held_y0), .sum(b_240)
    );
    wire signed [16:0] d_242;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_242 (
        .clk(clk), .strobe(rank[0]), .a(held_y2), .b(held_y0), .sum(d_242)
    );

    // Ranks 1 and 2. R = 1 / sqrt 2
    (* fraction = 30 *) wire signed [30:0] r_248;
    reference #(.WIDTH(31), .VALUE(759250125)) reference_248 (.value(r_248));
    (* fraction = 30 *) wire signed [47:0] product_244;
    multiplier #(.A_WIDTH(17), .B_WIDTH(31), .WIDTH(48)) multiplier_244 (
        .clk(clk), .strobe(rank[1]), .a(a_238), .b(r_248), .product(product_244)
    );
    (* fraction = 30 *) wire signed [47:0] product_246;
    multiplier #(.A_WIDTH(17), .B_WIDTH(31), .WIDTH(48)) multiplier_246 (
        .clk(clk), .strobe(rank[1]), .a(b_240), .b(r_248), .product(product_246)
    );
    (* fraction = 30 *) wire signed [48:0] difference_248;
    summer #(.A_WIDTH(47), .B_WIDTH(48), .WIDTH(49), .NEGATIVE(2'b10)) summer_248 (
        .clk(clk), .strobe(rank[2]), .a({c_236, 30'd0}), .b(product_244), .sum(difference_248)
    );
    (* fraction = 30 *) wire signed [48:0] difference_250;
    summer #(.A_WIDTH(47), .B_WIDTH(48), .WIDTH(49), .NEGATIVE(2'b10)) summer_250 (
        .clk(clk), .strobe(rank[2]), .a({d_242, 30'd0}), .b(product_246), .sum(difference_250)
    );

    // Ranks 3 to 5. T = 1 / (sqrt 2 - 1) = sqrt 2 + 1
    (* fraction = 30 *) wire signed [32:0] t_256;
    reference #(.WIDTH(33), .VALUE(64'd2592242074)) reference_256 (.value(t_256));
    (* fraction = 24 *) wire signed [39:0] j_252;
    wire overflow_252;
    multiplier #(.A_WIDTH(49), .B_WIDTH(33), .DROP(36), .WIDTH(40)) multiplier_252 (
        .clk(clk), .strobe(rank[3]), .a(difference_248), .b(t_256), .product(j_252), .overflow(overflow_252)
    );
    (* fraction = 24 *) wire signed [39:0] l_254;
    wire overflow_254;
    multiplier #(.A_WIDTH(49), .B_WIDTH(33), .DROP(36), .WIDTH(40)) multiplier_254 (
        .clk(clk), .strobe(rank[3]), .a(difference_250), .b(t_256), .product(l_254), .overflow(overflow_254)
    );
    wire signed [15:0] j_rounded;
    wire overflow_rounder_252;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_252 (
        .clk(clk), .strobe(rank[4]), .a(j_252), .rounded(j_rounded), .overflow(overflow_rounder_252)
    );
    wire signed [15:0] l_rounded;
    wire overflow_rounder_254;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_254 (
        .clk(clk), .strobe(rank[4]), .a(l_254), .rounded(l_rounded), .overflow(overflow_rounder_254)
    );
    wire signed [15:0] k_258;
    wire overflow_258;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_258 (
        .clk(clk), .strobe(rank[5]), .a(j_rounded), .b(a_238), .sum(k_258), .overflow(overflow_258)
    );
    wire signed [15:0] m_260;
    wire overflow_260;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_260 (
        .clk(clk), .strobe(rank[5]), .a(l_rounded), .b(b_240), .sum(m_260), .overflow(overflow_260)
    );

    // What can go wrong: each flag is held by its module until the next conversion.
    wire wrong;
    or or_wrong (wrong, overflow_252, overflow_254, overflow_rounder_252, overflow_rounder_254, overflow_258,
        overflow_260);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[6]), .wrong(wrong), .j_word(j_rounded), .k_word(k_258),
        .l_word(l_rounded), .m_word(m_260), .j(j), .k(k), .l(l), .m(m), .error(error)
    );

    // The rank sequencer: a rank is clocked when no digit-by-digit unit is at work.
    rank_sequencer #(.RANKS(7)) rank_sequencer (
        .clk(clk), .start(start), .ready(1'b1), .load(load), .rank(rank), .done(done)
    );
endmodule
