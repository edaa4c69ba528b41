// FIG. 3 of US 3,809,868: data converter for case I, two points and both end slopes.
//
//   A = X1 - X0   B = Y1 - Y0   J = (S0 A - B) / (S1 - S0)   K = A + J   L = S1 J   M = B + L
//
// Errata: the text sends 64 and 62 to the wrong places (as printed, 64 forms A and 62 forms B, yet 66, 74 and 78 take
// them as if they were exchanged, which gives wrong curves). Read as: 62 forms A, 64 forms B, 74 takes 62. "Sources 50
// and 62" are 50 and 52; "multiplier 56" is 66.
//
// Words (sign included . fraction bits): coordinates 16.0; A, B 17.0; slopes 32.18; 66 49.18; 68 50.18; 70 33.18;
// J and L, before rounding, 40.24; J..M 16.0.
// `error`: S0 = S1; J, K, L or M beyond 16 bits.
//
// Ranks: {62, 64, 70} {66} {68} {72} {rounder_72, 76} {74, rounder_76} {78} {output registers}; 72 takes 39 ticks.
// What is chosen for all five converters stands in converter_outputs.v.
`default_nettype none

module fig03_case1 (
    input  wire clk,
    input  wire start,
    input  wire signed [15:0] x0,
    input  wire signed [15:0] y0,
    input  wire signed [15:0] x1,
    input  wire signed [15:0] y1,
    (* fraction = 18 *) input wire signed [31:0] s0,
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
    wire [7:0] rank;

    // Sources.
    wire signed [15:0] held_x0;
    register #(.WIDTH(16)) source_50 (.clk(clk), .word(x0), .enable(load), .clear(1'b0), .q(held_x0));
    wire signed [15:0] held_y0;
    register #(.WIDTH(16)) source_52 (.clk(clk), .word(y0), .enable(load), .clear(1'b0), .q(held_y0));
    wire signed [15:0] held_y1;
    register #(.WIDTH(16)) source_54 (.clk(clk), .word(y1), .enable(load), .clear(1'b0), .q(held_y1));
    wire signed [15:0] held_x1;
    register #(.WIDTH(16)) source_56 (.clk(clk), .word(x1), .enable(load), .clear(1'b0), .q(held_x1));
    (* fraction = 18 *) wire signed [31:0] held_s0;
    register #(.WIDTH(32)) source_58 (.clk(clk), .word(s0), .enable(load), .clear(1'b0), .q(held_s0));
    (* fraction = 18 *) wire signed [31:0] held_s1;
    register #(.WIDTH(32)) source_60 (.clk(clk), .word(s1), .enable(load), .clear(1'b0), .q(held_s1));
    assign x0_out = held_x0;
    assign y0_out = held_y0;

    // Rank 0
    wire signed [16:0] a_62;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_62 (
        .clk(clk), .strobe(rank[0]), .a(held_x1), .b(held_x0), .sum(a_62)
    );
    wire signed [16:0] b_64;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_64 (
        .clk(clk), .strobe(rank[0]), .a(held_y1), .b(held_y0), .sum(b_64)
    );
    (* fraction = 18 *) wire signed [32:0] difference_70;
    summer #(.A_WIDTH(32), .B_WIDTH(32), .WIDTH(33), .NEGATIVE(2'b10)) summer_70 (
        .clk(clk), .strobe(rank[0]), .a(held_s1), .b(held_s0), .sum(difference_70)
    );

    // Ranks 1 and 2
    (* fraction = 18 *) wire signed [48:0] product_66;
    multiplier #(.A_WIDTH(17), .B_WIDTH(32), .WIDTH(49)) multiplier_66 (
        .clk(clk), .strobe(rank[1]), .a(a_62), .b(held_s0), .product(product_66)
    );
    (* fraction = 18 *) wire signed [49:0] numerator_68;
    summer #(.A_WIDTH(49), .B_WIDTH(35), .WIDTH(50), .NEGATIVE(2'b10)) summer_68 (
        .clk(clk), .strobe(rank[2]), .a(product_66), .b({b_64, 18'd0}), .sum(numerator_68)
    );

    // Rank 3: J. A zero denominator (S0 = S1) is an overflow, too.
    (* fraction = 24 *) wire signed [39:0] j_72;
    wire ready_72;
    wire parallel_72;
    wire overflow_72;
    divider #(.NUMERATOR_WIDTH(50), .DENOMINATOR_WIDTH(33), .FRACTION(24), .WIDTH(40)) divider_72 (
        .clk(clk), .start(rank[3]), .numerator(numerator_68), .denominator(difference_70), .quotient(j_72),
        .ready(ready_72), .zero_denominator(parallel_72), .overflow(overflow_72)
    );

    // Rank 4
    wire signed [15:0] j_rounded;
    wire overflow_rounder_72;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_72 (
        .clk(clk), .strobe(rank[4]), .a(j_72), .rounded(j_rounded), .overflow(overflow_rounder_72)
    );
    (* fraction = 24 *) wire signed [39:0] l_76;
    wire overflow_76;
    multiplier #(.A_WIDTH(40), .B_WIDTH(32), .DROP(18), .WIDTH(40)) multiplier_76 (
        .clk(clk), .strobe(rank[4]), .a(j_72), .b(held_s1), .product(l_76), .overflow(overflow_76)
    );

    // Ranks 5 and 6
    wire signed [15:0] k_74;
    wire overflow_74;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_74 (
        .clk(clk), .strobe(rank[5]), .a(j_rounded), .b(a_62), .sum(k_74), .overflow(overflow_74)
    );
    wire signed [15:0] l_rounded;
    wire overflow_rounder_76;
    rounder #(.A_WIDTH(40), .FRACTION(24), .WIDTH(16)) rounder_76 (
        .clk(clk), .strobe(rank[5]), .a(l_76), .rounded(l_rounded), .overflow(overflow_rounder_76)
    );
    wire signed [15:0] m_78;
    wire overflow_78;
    summer #(.A_WIDTH(16), .B_WIDTH(17), .WIDTH(16)) summer_78 (
        .clk(clk), .strobe(rank[6]), .a(l_rounded), .b(b_64), .sum(m_78), .overflow(overflow_78)
    );

    // What can go wrong: each flag is held by its module until the next conversion.
    wire wrong;
    or or_wrong (wrong, overflow_72, overflow_rounder_72, overflow_76, overflow_74, overflow_rounder_76, overflow_78);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[7]), .wrong(wrong), .j_word(j_rounded), .k_word(k_74),
        .l_word(l_rounded), .m_word(m_78), .j(j), .k(k), .l(l), .m(m), .error(error)
    );

    // The rank sequencer: a rank is clocked when no digit-by-digit unit is at work.
    rank_sequencer #(.RANKS(8)) rank_sequencer (
        .clk(clk), .start(start), .ready(ready_72), .load(load), .rank(rank), .done(done)
    );
endmodule
