using System.Runtime.InteropServices;

namespace FastPoints.Cli;

public static class Program
{
    public static int Main(string[] args)
    {
        using var cancellation = new CancellationTokenSource();
        // The first signal ends the work in good order; the second one kills, in case the first cannot get through.
        void Cancel(PosixSignalContext signal)
        {
            signal.Cancel = !cancellation.IsCancellationRequested;
            cancellation.Cancel();
        }
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);
        var utf8 = new UTF8Encoding(false);
        using var output = new StreamWriter(Console.OpenStandardOutput(), utf8, 4096);
        using var error = new StreamWriter(Console.OpenStandardError(), utf8, 1024) { AutoFlush = true };
        int status = CommandLine.Run(args, output, error, !Console.IsErrorRedirected, cancellation.Token);
        try
        {
            output.Flush();
        }
        catch (IOException)
        {
            // Whoever read standard output went away (| head): nothing left to say to them.
        }
        return status;
    }
}
