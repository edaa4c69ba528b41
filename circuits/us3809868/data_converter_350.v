`default_nettype none

// Data converter 350 of US 3,809,868, FIG. 11: converters 352, 354, 356, 358 and 360 for cases I to V, FIG. 3 and 5 to
// 8, and switch 362 that selects one of them. Converter 14 of FIG. 1 has the same inside, as the text says.
//
// `lines` has a bit for each case, case I lowest: it starts that converter together with `begin_350`. Likewise
// `lines_held` selects whose results come out. `done` and `error` are those of the selected converter.
module data_converter_350 (
    input wire clk,
    input wire begin_350,
    input wire [4:0] lines,
    input wire [4:0] lines_held,
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
    output wire signed [15:0] x0_out,
    output wire signed [15:0] y0_out,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire done,
    output wire error
);
    wire start_1;
    wire signed [15:0] j_1;
    wire signed [15:0] k_1;
    wire signed [15:0] l_1;
    wire signed [15:0] m_1;
    wire signed [15:0] x0_1;
    wire signed [15:0] y0_1;
    wire done_1;
    wire error_1;
    and and_start_1 (start_1, begin_350, lines[0]);
    fig03_case1 converter_352 (
        .clk(clk), .start(start_1), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .s0(s0), .s1(s1),
        .x0_out(x0_1), .y0_out(y0_1), .j(j_1), .k(k_1), .l(l_1), .m(m_1), .done(done_1), .error(error_1)
    );

    wire start_2;
    wire signed [15:0] j_2;
    wire signed [15:0] k_2;
    wire signed [15:0] l_2;
    wire signed [15:0] m_2;
    wire signed [15:0] x0_2;
    wire signed [15:0] y0_2;
    wire done_2;
    wire error_2;
    and and_start_2 (start_2, begin_350, lines[1]);
    fig05_case2 converter_354 (
        .clk(clk), .start(start_2), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s0(s0),
        .x0_out(x0_2), .y0_out(y0_2), .j(j_2), .k(k_2), .l(l_2), .m(m_2), .done(done_2), .error(error_2)
    );

    wire start_3;
    wire signed [15:0] j_3;
    wire signed [15:0] k_3;
    wire signed [15:0] l_3;
    wire signed [15:0] m_3;
    wire signed [15:0] x0_3;
    wire signed [15:0] y0_3;
    wire done_3;
    wire error_3;
    and and_start_3 (start_3, begin_350, lines[2]);
    fig06_case3 converter_356 (
        .clk(clk), .start(start_3), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s1(s1),
        .x0_out(x0_3), .y0_out(y0_3), .j(j_3), .k(k_3), .l(l_3), .m(m_3), .done(done_3), .error(error_3)
    );

    wire start_4;
    wire signed [15:0] j_4;
    wire signed [15:0] k_4;
    wire signed [15:0] l_4;
    wire signed [15:0] m_4;
    wire signed [15:0] x0_4;
    wire signed [15:0] y0_4;
    wire done_4;
    wire error_4;
    and and_start_4 (start_4, begin_350, lines[3]);
    fig07_case4 converter_358 (
        .clk(clk), .start(start_4), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s3(s3),
        .x0_out(x0_4), .y0_out(y0_4), .j(j_4), .k(k_4), .l(l_4), .m(m_4), .done(done_4), .error(error_4)
    );

    wire start_5;
    wire signed [15:0] j_5;
    wire signed [15:0] k_5;
    wire signed [15:0] l_5;
    wire signed [15:0] m_5;
    wire signed [15:0] x0_5;
    wire signed [15:0] y0_5;
    wire done_5;
    wire error_5;
    and and_start_5 (start_5, begin_350, lines[4]);
    fig08_case5 converter_360 (
        .clk(clk), .start(start_5), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2),
        .x0_out(x0_5), .y0_out(y0_5), .j(j_5), .k(k_5), .l(l_5), .m(m_5), .done(done_5), .error(error_5)
    );

    wire [63:0] coefficients;
    wire [33:0] position_and_state;
    data_switch #(.WIDTH(64)) switch_coefficients_362 (
        .lines(lines_held),
        .a({j_1, k_1, l_1, m_1}),
        .b({j_2, k_2, l_2, m_2}),
        .c({j_3, k_3, l_3, m_3}),
        .d({j_4, k_4, l_4, m_4}),
        .e({j_5, k_5, l_5, m_5}),
        .word(coefficients)
    );
    data_switch #(.WIDTH(34)) switch_position_362 (
        .lines(lines_held),
        .a({x0_1, y0_1, done_1, error_1}),
        .b({x0_2, y0_2, done_2, error_2}),
        .c({x0_3, y0_3, done_3, error_3}),
        .d({x0_4, y0_4, done_4, error_4}),
        .e({x0_5, y0_5, done_5, error_5}),
        .word(position_and_state)
    );
    assign {j, k, l, m} = coefficients;
    assign {x0_out, y0_out, done, error} = position_and_state;
endmodule
