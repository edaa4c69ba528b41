`default_nettype none

// The extended system of US 3,809,868, FIG. 11, before a tool: function generator 370 is that of FIG. 10 with the
// control of its velocity, and motors 328a and 328b move tool 328c step by step.
//
// All up to the generator stands in fig11_strokes, switch 386 with clipping 384 in clipping_386. `mark` is for the
// tool: up while it is 0.
//
// Chosen: MODE, `delay` and the rest as in fig10_tool_control, with intervals by MODE 1 or 4 from `delay` and the
// defaults otherwise. Outside of the window the tool is not hurried: 341 and 342 protect it there as well. It is set to
// the first point of each stroke, or character, as in fig10_system.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   MODE_min = 0, MODE_max = 4 *)
module fig11_tool #(
    parameter WIDTH = 12,           // these three as in fig09_function_generator
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6,
    parameter MODE = 1,             // of fig10_tool_control
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
    input wire [7:0] delay,         // modes 1 and 4
    input wire [15:0] reference_340,// mode 2
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire [3:0] windings_328a,
    output wire [3:0] windings_328b,
    output wire signed [15:0] x_328c,
    output wire signed [15:0] y_328c,
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    wire begun, start_370, busy_370, stop_370, error_370, error_384;
    wire signed [15:0] x0_370, y0_370, x_370, y_370;
    wire [2:0] quarters_370;
    wire mark_on, mark_inhibit_100, not_inhibited_100, started_370;
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
        .x(x), .y(y), .mark(mark_on), .busy(busy), .done(done), .error(error)
    );

    fig10_tool_control #(.WIDTH(WIDTH), .ENTRIES(ENTRIES), .ENTRY_WIDTH(ENTRY_WIDTH), .MODE(MODE)) control_370 (
        .clk(clk), .start(start_370), .j(j), .k(k), .l(l), .m(m), .x0(x0_370), .y0(y0_370), .quarters(quarters_370),
        .delay(delay), .reference_340(reference_340), .preset_write(1'b0), .preset_address(8'd0), .preset_word(8'd0),
        .x(x_370), .y(y_370), .up_304(up_304), .down_306(down_306), .up_314(up_314), .down_316(down_316),
        .hold_345(), .started(started_370), .busy(busy_370), .done(stop_370), .error(error_370)
    );
    stepping_motor #(.WIDTH(16)) motor_328a (
        .clk(clk), .preset(started_370), .preset_value(x0_370), .up(up_304), .down(down_306),
        .windings(windings_328a), .position(x_328c)
    );
    stepping_motor #(.WIDTH(16)) motor_328b (
        .clk(clk), .preset(started_370), .preset_value(y0_370), .up(up_314), .down(down_316),
        .windings(windings_328b), .position(y_328c)
    );

    // The tool's mark.
    clipping_386 clipping_386 (
        .clk(clk), .load(begun), .control_388(control_388),
        .x_min_390(x_min_390), .x_max_392(x_max_392), .y_min_394(y_min_394), .y_max_396(y_max_396),
        .x(x_370), .y(y_370),
        .mark_inhibit_100(mark_inhibit_100), .full_speed_109(), .error(error_384)
    );
    not not_inhibit_100 (not_inhibited_100, mark_inhibit_100);
    and and_mark (mark, mark_on, not_inhibited_100);
endmodule
