// FIG. 14 of US 3,809,868: scaling of a stroke by a factor, directly on J, K, L and M.
//
//   J' = s J   K' = s K   L' = s L   M' = s M
//
// about the initial point: X0 and Y0 stay. A factor of -1 turns the stroke by a half. The equations of FIG. 14A are
// lost; they follow from the connections.
//
// Words (sign included . fraction bits): factor 471 16.12, from -8 to 7.9998; products 32.12; J..M 16.0.
// `error`: a result beyond 16 bits.
//
// Ranks: {470..476} {rounders} {output registers}.
// Chosen, where the patent is silent:
//  - the factor's word;
//  - the results are rounded to the nearest count, halves away from zero, so that s and -s differ just by the sign. J'
//    and K' are rounded by themselves, so K' - J' may be off by a count: the next stroke begins where this one has
//    ended;
//  - the inputs are kept in registers from the tick of `start` on; `done` rises when the result stands, and stays until
//    the next start; `error` goes with it, and J'..M' are then 0. A start while busy is ignored.
`default_nettype none

module fig14_scaling (
    input wire clk,
    input wire start,
    (* fraction = 12 *) input wire signed [15:0] factor_471,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    output wire signed [15:0] j_out,
    output wire signed [15:0] k_out,
    output wire signed [15:0] l_out,
    output wire signed [15:0] m_out,
    output wire done,
    output wire error
);
    wire load;
    wire [2:0] rank;

    // Sources.
    wire signed [15:0] held_j;
    register #(.WIDTH(16)) source_j (.clk(clk), .word(j), .enable(load), .clear(1'b0), .q(held_j));
    wire signed [15:0] held_k;
    register #(.WIDTH(16)) source_k (.clk(clk), .word(k), .enable(load), .clear(1'b0), .q(held_k));
    wire signed [15:0] held_l;
    register #(.WIDTH(16)) source_l (.clk(clk), .word(l), .enable(load), .clear(1'b0), .q(held_l));
    wire signed [15:0] held_m;
    register #(.WIDTH(16)) source_m (.clk(clk), .word(m), .enable(load), .clear(1'b0), .q(held_m));
    (* fraction = 12 *) wire signed [15:0] held_471;
    register #(.WIDTH(16)) source_471 (.clk(clk), .word(factor_471), .enable(load), .clear(1'b0), .q(held_471));

    // Rank 0
    (* fraction = 12 *) wire signed [31:0] product_470;
    multiplier #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(32)) multiplier_470 (
        .clk(clk), .strobe(rank[0]), .a(held_471), .b(held_j), .product(product_470)
    );
    (* fraction = 12 *) wire signed [31:0] product_472;
    multiplier #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(32)) multiplier_472 (
        .clk(clk), .strobe(rank[0]), .a(held_471), .b(held_k), .product(product_472)
    );
    (* fraction = 12 *) wire signed [31:0] product_474;
    multiplier #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(32)) multiplier_474 (
        .clk(clk), .strobe(rank[0]), .a(held_471), .b(held_l), .product(product_474)
    );
    (* fraction = 12 *) wire signed [31:0] product_476;
    multiplier #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(32)) multiplier_476 (
        .clk(clk), .strobe(rank[0]), .a(held_471), .b(held_m), .product(product_476)
    );

    // Rank 1
    wire signed [15:0] rounded_470;
    wire overflow_470;
    rounder #(.A_WIDTH(32), .FRACTION(12), .WIDTH(16), .HALVES(1)) rounder_470 (
        .clk(clk), .strobe(rank[1]), .a(product_470), .rounded(rounded_470), .overflow(overflow_470)
    );
    wire signed [15:0] rounded_472;
    wire overflow_472;
    rounder #(.A_WIDTH(32), .FRACTION(12), .WIDTH(16), .HALVES(1)) rounder_472 (
        .clk(clk), .strobe(rank[1]), .a(product_472), .rounded(rounded_472), .overflow(overflow_472)
    );
    wire signed [15:0] rounded_474;
    wire overflow_474;
    rounder #(.A_WIDTH(32), .FRACTION(12), .WIDTH(16), .HALVES(1)) rounder_474 (
        .clk(clk), .strobe(rank[1]), .a(product_474), .rounded(rounded_474), .overflow(overflow_474)
    );
    wire signed [15:0] rounded_476;
    wire overflow_476;
    rounder #(.A_WIDTH(32), .FRACTION(12), .WIDTH(16), .HALVES(1)) rounder_476 (
        .clk(clk), .strobe(rank[1]), .a(product_476), .rounded(rounded_476), .overflow(overflow_476)
    );

    // Each rounder holds its flag until the next scaling.
    wire wrong;
    or or_wrong (wrong, overflow_470, overflow_472, overflow_474, overflow_476);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[2]), .wrong(wrong),
        .j_word(rounded_470), .k_word(rounded_472), .l_word(rounded_474), .m_word(rounded_476),
        .j(j_out), .k(k_out), .l(l_out), .m(m_out), .error(error)
    );

    rank_sequencer #(.RANKS(3)) rank_sequencer (
        .clk(clk), .start(start), .ready(1'b1), .load(load), .rank(rank), .done(done)
    );
endmodule
