module n005_numbers (output wire [3:0] a, b, c, d, e, f, g);
    assign a = 4'b10x1;
    assign b = 4'bzzzz;
    assign c = 4'd16;
    assign d = 4'b12;
    assign e = 0'd1;
    assign f = 65'd1;
    assign g = 4'h;
    localparam BIG = 4294967296;
    localparam HUGE = 64'd18446744073709551616;
endmodule
