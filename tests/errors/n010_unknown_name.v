module n010_unknown_name #(parameter WIDTH = 4) (input wire [WIDTH-1:0] major_32, output wire [WIDTH-1:0] b, c);
    assign b = major_23;
    assign c = {later, {(WIDHT-1){1'b0}}};
    wire later = major_32[0];
    and and_1 (undeclared, later, later);
    wire d = and_1;
endmodule
