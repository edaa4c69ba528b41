`default_nettype none

// Switch 386 of US 3,809,868, FIG. 11, with clipping circuit 384 (FIG. 16) and its sources 390 to 396: under control
// 388 what generator 370 draws goes to the display through 384, or straight.
//
// Erratum followed: the text lets the *parameters* go to 384; it needs X(t) and Y(t).
//
// Chosen: control and window are kept from `load` on, the tick of the start of a stroke or character; 386 passes or
// stops the two outputs of 384, to mark inhibit 100 and to switch 109; `error` is high while 388 is 1 and the window
// has a minimum above its maximum.
module clipping_386 (
    input wire clk,
    input wire load,
    input wire control_388,                     // 1: through 384
    input wire signed [15:0] x_min_390,
    input wire signed [15:0] x_max_392,
    input wire signed [15:0] y_min_394,
    input wire signed [15:0] y_max_396,
    input wire signed [15:0] x,                 // X(t), Y(t)
    input wire signed [15:0] y,
    output wire mark_inhibit_100,
    output wire full_speed_109,
    output wire error
);
    wire held_388;
    wire signed [15:0] held_390, held_392, held_394, held_396;
    register #(.WIDTH(1)) register_388 (.clk(clk), .word(control_388), .enable(load), .clear(1'b0), .q(held_388));
    register #(.WIDTH(16)) source_390 (.clk(clk), .word(x_min_390), .enable(load), .clear(1'b0), .q(held_390));
    register #(.WIDTH(16)) source_392 (.clk(clk), .word(x_max_392), .enable(load), .clear(1'b0), .q(held_392));
    register #(.WIDTH(16)) source_394 (.clk(clk), .word(y_min_394), .enable(load), .clear(1'b0), .q(held_394));
    register #(.WIDTH(16)) source_396 (.clk(clk), .word(y_max_396), .enable(load), .clear(1'b0), .q(held_396));

    wire inhibit_384, fast_384, error_384;
    fig16_clipping clipping_384 (
        .x(x), .y(y), .x_min_390(held_390), .x_max_392(held_392), .y_min_394(held_394), .y_max_396(held_396),
        .inside(), .mark_inhibit_100(inhibit_384), .full_speed_109(fast_384), .error(error_384)
    );
    and switch_inhibit_386 (mark_inhibit_100, inhibit_384, held_388);
    and switch_fast_386 (full_speed_109, fast_384, held_388);
    and switch_error_386 (error, error_384, held_388);
endmodule
