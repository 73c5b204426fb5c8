namespace FastPoints.Cli;

public static class Program
{
    // Until the process has ended: a signal that comes behind the work changes nothing any more.
    static readonly CancellationTokenSource s_cancellation = new(), s_discard = new();
    static PosixSignalRegistration? s_interrupt, s_terminate;

    public static int Main(string[] args)
    {
        // The first signal ends the work cleanly, so that a build can go on; with a second Ctrl-C nothing is kept; the third one
        // kills, in case the others cannot get through. A scheduler's SIGTERM comes twice where it is sent to all processes of a
        // job, and the job's shell passes it on.
        void Cancel(PosixSignalContext signal)
        {
            signal.Cancel = !s_discard.IsCancellationRequested;
            if (s_cancellation.IsCancellationRequested && signal.Signal == PosixSignal.SIGINT)
                s_discard.Cancel();
            s_cancellation.Cancel();
        }
        s_interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Cancel);
        s_terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Cancel);
        var utf8 = new UTF8Encoding(false);
        // Not disposed: that would write once more what a full disk has refused.
        var output = new StreamWriter(Console.OpenStandardOutput(), utf8, 4096);
        using var error = new StreamWriter(Console.OpenStandardError(), utf8, 1024) { AutoFlush = true };
        int status = ExitStatus.Failed;
        try
        {
            status = CommandLine.Run(NonUtf8Names.WithLinks(args), output, error, !Console.IsErrorRedirected,
                s_cancellation.Token, s_discard.Token);
            output.Flush();
        }
        catch (UsageException e)
        {
            error.WriteLine("fastpoints: " + e.Message);
            return ExitStatus.Usage;
        }
        // A reader that went away (| head) is no failure, and no exception either.
        catch (IOException e)
        {
            error.WriteLine("fastpoints: standard output: " + e.Message);
            return status == ExitStatus.Done ? ExitStatus.Failed : status;
        }
        finally
        {
            NonUtf8Names.DeleteLinks();
        }
        return status;
    }
}
