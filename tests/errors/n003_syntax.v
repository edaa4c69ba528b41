module n003_syntax (input wire a, output wire b)
    assign b = a;
endmodule

module second (input wire a, output wire b);
    assign b a;
    and (b, a, a;
    wire wire;
    for (i = 0; i < 2; i = i + 1) begin
    end
    summer (.terms(a));
endmodule

stray text
module third (input wire a, output wire b);
    assign b = a
endmodule
