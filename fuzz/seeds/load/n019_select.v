module n019_select (input wire [7:4] a, input wire s, output wire b, c, output wire [1:0] d, e);
    assign b = a[3];
    assign c = s[0];
    assign d = a[8:7];
    assign e = a[4 -: 2];
    localparam [3:0] P = 5;
    wire f = P[4];
endmodule
