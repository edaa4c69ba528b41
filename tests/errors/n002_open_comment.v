module n002_open_comment (input wire a, output wire b);
    assign b = a; /* and so on
endmodule
