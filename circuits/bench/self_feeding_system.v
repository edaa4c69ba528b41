`default_nettype none

// The system of US 3,809,868, FIG. 11, fed with stroke after stroke, for measuring: nothing comes from outside, and one
// word at the end tells whether two simulators did the same.
//
// Pseudo-random words are drawn at every tick; whenever the system is at rest, those of that tick are the inputs of
// the next stroke: points up to 512 counts from the origin, slopes below 4, any case, any subset of the
// transformations, clipped or not. Many are refused, as such numbers have no solution; the next words are taken at
// once.
module self_feeding_system (
    input wire clk,
    output wire [31:0] checksum
);
    wire [30:0] random_a, random_b, random_c, random_d, random_e;
    lfsr #(.SEED(1)) source_a (.clk(clk), .q(random_a));
    lfsr #(.SEED(1522157)) source_b (.clk(clk), .q(random_b));
    lfsr #(.SEED(3809868)) source_c (.clk(clk), .q(random_c));
    lfsr #(.SEED(1974)) source_d (.clk(clk), .q(random_d));
    lfsr #(.SEED(1989)) source_e (.clk(clk), .q(random_e));

    wire busy, start;
    not at_rest (start, busy);

    wire signed [15:0] x, y;
    fig11_system #(.HALF(4)) system (
        .clk(clk),
        .start(start),
        .case_364(random_e[2:0]),
        .x0(16'd0),
        .y0(16'd0),
        .x1({{6{random_a[9]}}, random_a[9:0]}),
        .y1({{6{random_a[19]}}, random_a[19:10]}),
        .x2({{6{random_a[29]}}, random_a[29:20]}),
        .y2({{6{random_b[9]}}, random_b[9:0]}),
        .x3({{6{random_b[19]}}, random_b[19:10]}),
        .y3({{6{random_b[29]}}, random_b[29:20]}),
        .s0({{11{random_c[20]}}, random_c[20:0]}),
        .s1({{11{random_d[20]}}, random_d[20:0]}),
        .s3({{11{random_e[30]}}, random_e[30:10]}),
        .quarters({1'b0, random_e[3], 1'b1}),
        .control_382(random_e[8:4]),
        .control_450(1'b1),
        .control_452(1'b0),
        .control_454(1'b0),
        .control_456(1'b1),
        .control_458(1'b0),
        .control_460(1'b0),
        .control_462(1'b0),
        .control_464(1'b0),
        .angle_410(random_c[30:15]),
        .factor_471({{3{random_d[12]}}, random_d[12:0]}),
        .offset_x_488(16'd100),
        .offset_y_490(-16'sd100),
        .code_449({2'b01, random_d[5:0]}),
        .scale_514(16'sd410),
        .control_388(random_e[9]),
        .x_min_390(-16'sd300),
        .x_max_392(16'sd300),
        .y_min_394(-16'sd300),
        .y_max_396(16'sd300),
        .j(),
        .k(),
        .l(),
        .m(),
        .x(x),
        .y(y),
        .up_304(),
        .down_306(),
        .up_314(),
        .down_316(),
        .mark(),
        .busy(busy),
        .done(),
        .error()
    );

    checksum #(.WIDTH(32)) sum (.clk(clk), .word({y, x}), .sum(checksum));
endmodule
