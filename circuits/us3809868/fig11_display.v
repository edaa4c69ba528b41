`default_nettype none

// The extended system of US 3,809,868, FIG. 11, with FIG. 4 as function generator 370, whose mark inhibit 100 and
// switch 109 are those that FIG. 16 names: outside of the window the mark is off and the point hurries at full
// velocity.
//
// All up to the generator stands in fig11_strokes, switch 386 with clipping 384 in clipping_386.
//
// Chosen: x, y and mark go to the display a tick late. So they show the end of a stroke in the tick of `done`, which
// comes a tick after that of the generator.
(* PIECE_BITS_min = 0, PIECE_BITS_max = 7, VELOCITY_BITS_min = 4, VELOCITY_BITS_max = 40 *)
module fig11_display #(
    parameter PIECE_BITS = 4,       // these two as in fig04_function_generator
    parameter VELOCITY_BITS = 26,
    parameter IMAGE = "letters"     // of 404
) (
    input wire clk,
    input wire start,
    input wire [2:0] case_364,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] x1,
    input wire signed [15:0] y1,
    input wire signed [15:0] x2,
    input wire signed [15:0] y2,
    input wire signed [15:0] x3,
    input wire signed [15:0] y3,
    (* fraction = 18 *) input wire signed [31:0] s0,
    (* fraction = 18 *) input wire signed [31:0] s1,
    (* fraction = 18 *) input wire signed [31:0] s3,
    input wire [2:0] quarters,
    input wire [4:0] control_382,
    input wire control_450,
    input wire control_452,
    input wire control_454,
    input wire control_456,
    input wire control_458,
    input wire control_460,
    input wire control_462,
    input wire control_464,
    input wire [15:0] angle_410,
    (* fraction = 12 *) input wire signed [15:0] factor_471,
    input wire signed [15:0] offset_x_488,
    input wire signed [15:0] offset_y_490,
    input wire [7:0] code_449,
    (* fraction = 12 *) input wire signed [15:0] scale_514,
    input wire control_388,
    input wire signed [15:0] x_min_390,
    input wire signed [15:0] x_max_392,
    input wire signed [15:0] y_min_394,
    input wire signed [15:0] y_max_396,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    wire begun, start_370, busy_370, stop_370, error_370, error_384;
    wire signed [15:0] x0_370, y0_370, x_370, y_370;
    wire [2:0] quarters_370;
    wire mark_on, mark_inhibit_100, full_speed_109;
    wire signed [15:0] x_pen, y_pen;
    fig11_strokes #(.IMAGE(IMAGE)) strokes (
        .clk(clk), .start(start), .case_364(case_364),
        .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2), .x3(x3), .y3(y3), .s0(s0), .s1(s1), .s3(s3),
        .quarters(quarters), .control_382(control_382),
        .control_450(control_450), .control_452(control_452), .control_454(control_454), .control_456(control_456),
        .control_458(control_458), .control_460(control_460), .control_462(control_462), .control_464(control_464),
        .angle_410(angle_410), .factor_471(factor_471), .offset_x_488(offset_x_488), .offset_y_490(offset_y_490),
        .code_449(code_449), .scale_514(scale_514),
        .error_384(error_384), .busy_370(busy_370), .stop_370(stop_370), .error_370(error_370),
        .x_370(x_370), .y_370(y_370),
        .begun(begun), .start_370(start_370), .j(j), .k(k), .l(l), .m(m),
        .x0_370(x0_370), .y0_370(y0_370), .quarters_370(quarters_370),
        .x(x_pen), .y(y_pen), .mark(mark_on), .busy(busy), .done(done), .error(error)
    );

    // 100 is inside; its mark tells 400 and the display that a stroke is drawn.
    fig04_function_generator #(.PIECE_BITS(PIECE_BITS), .VELOCITY_BITS(VELOCITY_BITS)) generator_370 (
        .clk(clk), .start(start_370), .j(j), .k(k), .l(l), .m(m), .x0(x0_370), .y0(y0_370), .quarters(quarters_370),
        .fast(full_speed_109), .inhibit(mark_inhibit_100), .x(x_370), .y(y_370),
        .mark(busy_370), .busy(), .done(stop_370), .error(error_370)
    );
    clipping_386 clipping_386 (
        .clk(clk), .load(begun), .control_388(control_388),
        .x_min_390(x_min_390), .x_max_392(x_max_392), .y_min_394(y_min_394), .y_max_396(y_max_396),
        .x(x_370), .y(y_370),
        .mark_inhibit_100(mark_inhibit_100), .full_speed_109(full_speed_109), .error(error_384)
    );

    register #(.WIDTH(16)) register_x (.clk(clk), .word(x_pen), .enable(1'b1), .clear(1'b0), .q(x));
    register #(.WIDTH(16)) register_y (.clk(clk), .word(y_pen), .enable(1'b1), .clear(1'b0), .q(y));
    register #(.WIDTH(1)) register_mark (.clk(clk), .word(mark_on), .enable(1'b1), .clear(1'b0), .q(mark));
endmodule
