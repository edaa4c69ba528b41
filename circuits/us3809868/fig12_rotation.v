// FIG. 12 of US 3,809,868: rotation of a stroke by any angle, directly on J, K, L and M.
//
//   J' = J cos a - L sin a   K' = K cos a - M sin a   L' = J sin a + L cos a   M' = K sin a + M cos a
//
// Counter-clockwise for an angle above 0 where y points upwards, about the initial point: X0 and Y0 stay. For linked
// strokes each initial point is the end of the stroke before, so a chain turns about its first point.
//
// Errata: the printed summers 332 to 338 and multipliers "330 and 322" are 432 to 438, 430 and 422. The equations of
// FIG. 12A are lost; they follow from the connections.
//
// Words (sign included . fraction bits): angle 16 bits, 2^16 a full turn; sine and cosine 26.24, 1 is exact; products
// 42.24; sums 43.24; J..M 16.0.
// `error`: a result beyond 16 bits.
//
// Ranks: {416..430} {432..438} {rounders} {output registers}; 412 and 414 are combinational.
// Chosen, where the patent is silent:
//  - 412 and 414 are look-up tables, as the text has it for digital inputs: 1025 words of a quarter turn, interpolated
//    linearly (see block angle_converter); their error is below 3.5e-7, and none at the quarter turns;
//  - the results are rounded to the nearest count, halves away from zero, so that a turn by a half more changes just
//    the signs. J' and K' are rounded by themselves, so K' - J' may be off by a count: the next stroke begins where
//    this one has ended;
//  - the inputs are kept in registers from the tick of `start` on; `done` rises when the result stands, and stays until
//    the next start; `error` goes with it, and J'..M' are then 0. A start while busy is ignored.
`default_nettype none

module fig12_rotation (
    input wire clk,
    input wire start,
    input wire [15:0] angle_410,
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
    wire [3:0] rank;

    // Sources.
    wire signed [15:0] held_j;
    register #(.WIDTH(16)) source_j (.clk(clk), .word(j), .enable(load), .clear(1'b0), .q(held_j));
    wire signed [15:0] held_k;
    register #(.WIDTH(16)) source_k (.clk(clk), .word(k), .enable(load), .clear(1'b0), .q(held_k));
    wire signed [15:0] held_l;
    register #(.WIDTH(16)) source_l (.clk(clk), .word(l), .enable(load), .clear(1'b0), .q(held_l));
    wire signed [15:0] held_m;
    register #(.WIDTH(16)) source_m (.clk(clk), .word(m), .enable(load), .clear(1'b0), .q(held_m));

    // Control 410 and the converters.
    wire [15:0] held_410;
    register #(.WIDTH(16)) control_410 (.clk(clk), .word(angle_410), .enable(load), .clear(1'b0), .q(held_410));
    (* fraction = 24 *) wire signed [25:0] cosine_412;
    angle_converter #(.COSINE(1)) converter_412 (.angle(held_410), .value(cosine_412));
    (* fraction = 24 *) wire signed [25:0] sine_414;
    angle_converter #(.COSINE(0)) converter_414 (.angle(held_410), .value(sine_414));

    // Rank 0
    (* fraction = 24 *) wire signed [41:0] product_416;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_416 (
        .clk(clk), .strobe(rank[0]), .a(cosine_412), .b(held_j), .product(product_416)
    );
    (* fraction = 24 *) wire signed [41:0] product_418;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_418 (
        .clk(clk), .strobe(rank[0]), .a(cosine_412), .b(held_k), .product(product_418)
    );
    (* fraction = 24 *) wire signed [41:0] product_420;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_420 (
        .clk(clk), .strobe(rank[0]), .a(cosine_412), .b(held_l), .product(product_420)
    );
    (* fraction = 24 *) wire signed [41:0] product_422;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_422 (
        .clk(clk), .strobe(rank[0]), .a(cosine_412), .b(held_m), .product(product_422)
    );
    (* fraction = 24 *) wire signed [41:0] product_424;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_424 (
        .clk(clk), .strobe(rank[0]), .a(sine_414), .b(held_l), .product(product_424)
    );
    (* fraction = 24 *) wire signed [41:0] product_426;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_426 (
        .clk(clk), .strobe(rank[0]), .a(sine_414), .b(held_m), .product(product_426)
    );
    (* fraction = 24 *) wire signed [41:0] product_428;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_428 (
        .clk(clk), .strobe(rank[0]), .a(sine_414), .b(held_j), .product(product_428)
    );
    (* fraction = 24 *) wire signed [41:0] product_430;
    multiplier #(.A_WIDTH(26), .B_WIDTH(16), .WIDTH(42)) multiplier_430 (
        .clk(clk), .strobe(rank[0]), .a(sine_414), .b(held_k), .product(product_430)
    );

    // Rank 1
    (* fraction = 24 *) wire signed [42:0] sum_432;
    summer #(.A_WIDTH(42), .B_WIDTH(42), .WIDTH(43), .NEGATIVE(2'b10)) summer_432 (
        .clk(clk), .strobe(rank[1]), .a(product_416), .b(product_424), .sum(sum_432)
    );
    (* fraction = 24 *) wire signed [42:0] sum_434;
    summer #(.A_WIDTH(42), .B_WIDTH(42), .WIDTH(43), .NEGATIVE(2'b10)) summer_434 (
        .clk(clk), .strobe(rank[1]), .a(product_418), .b(product_426), .sum(sum_434)
    );
    (* fraction = 24 *) wire signed [42:0] sum_436;
    summer #(.A_WIDTH(42), .B_WIDTH(42), .WIDTH(43)) summer_436 (
        .clk(clk), .strobe(rank[1]), .a(product_428), .b(product_420), .sum(sum_436)
    );
    (* fraction = 24 *) wire signed [42:0] sum_438;
    summer #(.A_WIDTH(42), .B_WIDTH(42), .WIDTH(43)) summer_438 (
        .clk(clk), .strobe(rank[1]), .a(product_430), .b(product_422), .sum(sum_438)
    );

    // Rank 2
    wire signed [15:0] rounded_432;
    wire overflow_432;
    rounder #(.A_WIDTH(43), .FRACTION(24), .WIDTH(16), .HALVES(1)) rounder_432 (
        .clk(clk), .strobe(rank[2]), .a(sum_432), .rounded(rounded_432), .overflow(overflow_432)
    );
    wire signed [15:0] rounded_434;
    wire overflow_434;
    rounder #(.A_WIDTH(43), .FRACTION(24), .WIDTH(16), .HALVES(1)) rounder_434 (
        .clk(clk), .strobe(rank[2]), .a(sum_434), .rounded(rounded_434), .overflow(overflow_434)
    );
    wire signed [15:0] rounded_436;
    wire overflow_436;
    rounder #(.A_WIDTH(43), .FRACTION(24), .WIDTH(16), .HALVES(1)) rounder_436 (
        .clk(clk), .strobe(rank[2]), .a(sum_436), .rounded(rounded_436), .overflow(overflow_436)
    );
    wire signed [15:0] rounded_438;
    wire overflow_438;
    rounder #(.A_WIDTH(43), .FRACTION(24), .WIDTH(16), .HALVES(1)) rounder_438 (
        .clk(clk), .strobe(rank[2]), .a(sum_438), .rounded(rounded_438), .overflow(overflow_438)
    );

    // Each rounder holds its flag until the next rotation.
    wire wrong;
    or or_wrong (wrong, overflow_432, overflow_434, overflow_436, overflow_438);

    // The results are taken in the last rank, refused when anything is wrong.
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(rank[3]), .wrong(wrong),
        .j_word(rounded_432), .k_word(rounded_434), .l_word(rounded_436), .m_word(rounded_438),
        .j(j_out), .k(k_out), .l(l_out), .m(m_out), .error(error)
    );

    rank_sequencer #(.RANKS(4)) rank_sequencer (
        .clk(clk), .start(start), .ready(1'b1), .load(load), .rank(rank), .done(done)
    );
endmodule
