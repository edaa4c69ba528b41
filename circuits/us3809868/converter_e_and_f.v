// What FIG. 5 and FIG. 6 of US 3,809,868 share: 110, 114 to 126 and 132 to 140. The text gives FIG. 6 as differences to
// FIG. 5, from which these are taken over.
//
//   A = X1 - X0   B = Y1 - Y0   E = (S C - D) / (S A - B)   F = sqrt(1 - E^2)
//
// C, D and slope S are those of the figure around it: X1 - X3, Y1 - Y3 and S0 in FIG. 5; X3 - X0, Y3 - Y0 and S1 in
// FIG. 6. So E is the cosine at P3 there, the sine here. `rank` are the first eight strobes of the figure's sequencer.
// `wrong`: E outside 0 < E < 1, or S A = B.
`default_nettype none

module converter_e_and_f (
    input wire clk,
    input wire [7:0] rank,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] x1,
    input wire signed [15:0] y1,
    input wire signed [16:0] c,
    input wire signed [16:0] d,
    (* fraction = 18 *) input wire signed [31:0] slope,
    output wire signed [16:0] a_110,
    output wire signed [16:0] b_138,
    (* fraction = 30 *) output wire signed [30:0] e_120,
    (* fraction = 30 *) output wire [29:0] f_116,
    (* fraction = 30 *) output wire signed [31:0] denominator_114,
    output wire ready,
    output wire wrong
);
    // Rank 0
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_110 (
        .clk(clk), .strobe(rank[0]), .a(x1), .b(x0), .sum(a_110)
    );
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(17), .NEGATIVE(2'b10)) summer_138 (
        .clk(clk), .strobe(rank[0]), .a(y1), .b(y0), .sum(b_138)
    );

    // Ranks 1 and 2
    (* fraction = 18 *) wire signed [48:0] product_136;
    multiplier #(.A_WIDTH(17), .B_WIDTH(32), .WIDTH(49)) multiplier_136 (
        .clk(clk), .strobe(rank[1]), .a(a_110), .b(slope), .product(product_136)
    );
    (* fraction = 18 *) wire signed [48:0] product_140;
    multiplier #(.A_WIDTH(17), .B_WIDTH(32), .WIDTH(49)) multiplier_140 (
        .clk(clk), .strobe(rank[1]), .a(c), .b(slope), .product(product_140)
    );
    (* fraction = 18 *) wire signed [49:0] denominator_132;
    summer #(.A_WIDTH(49), .B_WIDTH(35), .WIDTH(50), .NEGATIVE(2'b10)) summer_132 (
        .clk(clk), .strobe(rank[2]), .a(product_136), .b({b_138, 18'd0}), .sum(denominator_132)
    );
    (* fraction = 18 *) wire signed [49:0] numerator_134;
    summer #(.A_WIDTH(49), .B_WIDTH(35), .WIDTH(50), .NEGATIVE(2'b10)) summer_134 (
        .clk(clk), .strobe(rank[2]), .a(product_140), .b({d, 18'd0}), .sum(numerator_134)
    );

    // E, and F = sqrt(1 - E^2). |E| >= 1 overflows 120; 1 - E^2 = 1 (E = 0) overflows 122; E < 0 shows in its sign.
    wire ready_120;
    wire degenerate_120;
    wire overflow_120;
    divider #(.NUMERATOR_WIDTH(50), .DENOMINATOR_WIDTH(50), .FRACTION(30), .WIDTH(31)) divider_120 (
        .clk(clk), .start(rank[3]), .numerator(numerator_134), .denominator(denominator_132), .quotient(e_120),
        .ready(ready_120), .zero_denominator(degenerate_120), .overflow(overflow_120)
    );
    (* fraction = 60 *) wire signed [60:0] square_124;
    squaring_circuit #(.A_WIDTH(31), .WIDTH(61)) squaring_circuit_124 (
        .clk(clk), .strobe(rank[4]), .a(e_120), .square(square_124)
    );
    wire signed [1:0] one_126;
    reference #(.WIDTH(2), .VALUE(1)) reference_126 (.value(one_126));
    (* fraction = 60 *) wire signed [60:0] radicand_122;
    wire overflow_122;
    summer #(.A_WIDTH(62), .B_WIDTH(61), .WIDTH(61), .NEGATIVE(2'b10)) summer_122 (
        .clk(clk), .strobe(rank[5]), .a({one_126, 60'd0}), .b(square_124), .sum(radicand_122),
        .overflow(overflow_122)
    );
    wire ready_116;
    square_rooter #(.PAIRS(30)) square_rooter_116 (
        .clk(clk), .start(rank[6]), .radicand(radicand_122), .root(f_116), .ready(ready_116)
    );
    wire signed [1:0] minus_one_118;
    reference #(.WIDTH(2), .VALUE(-1)) reference_118 (.value(minus_one_118));
    summer_3 #(.A_WIDTH(31), .B_WIDTH(32), .C_WIDTH(31), .WIDTH(32)) summer_114 (
        .clk(clk), .strobe(rank[7]), .a({1'b0, f_116}), .b({minus_one_118, 30'd0}), .c(e_120), .sum(denominator_114)
    );

    and and_ready (ready, ready_120, ready_116);
    or or_wrong (wrong, e_120[30], overflow_120, overflow_122);
endmodule
