module n015_parameter_value (input wire clk, input wire [3:0] a, output wire [4:0] b, c, d);
    multiplexer #(.WIDTH(65)) switch_1 (.a(a[0]), .b(a[1]), .x1(a), .x2(a), .z(b));
    rounder #(.A_WIDTH(4), .FRACTION(4), .WIDTH(5)) rounder_2 (.clk(clk), .strobe(a[0]), .a(a), .rounded(c));
    inner #(.INIT(16)) inner_1 (.y(d));
    localparam [2:0] NEGATIVE = -1;
endmodule

module inner #(parameter [3:0] INIT = 0) (output wire [4:0] y);
    assign y = {1'b0, INIT};
endmodule

(* MODE_min = 0, MODE_max = 4, STEP_min = 1 *)
module ranged #(parameter MODE = 2, parameter STEP = 0) (input wire a);
endmodule

module use_ranged (input wire a);
    ranged #(.MODE(4), .STEP(1)) good (.a(a));
    ranged #(.MODE(5), .STEP(1)) beyond (.a(a));
    ranged #(.MODE(0 - 1), .STEP(1)) below (.a(a));
    ranged left_at_its_default (.a(a));
endmodule
