namespace FastPoints.Cli;

public sealed class StoppedException(string target, string line) : OperationCanceledException(
    "cancelled; what is built of " + target + " is kept, and this goes on: " + line
    + "   (--discard begins anew and keeps nothing)");
