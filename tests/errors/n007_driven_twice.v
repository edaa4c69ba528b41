module n007_driven_twice (input wire [3:0] a, output wire [7:4] b, output wire c);
    assign b = a;
    assign b[6:5] = a[1:0];
    and and_1 (c, a[0], a[1]);
    or or_1 (c, a[2], a[3]);
endmodule
