namespace FastPoints.HostTests.Cli;

sealed class CliCall
{
    public static Action<string, string> SummaryWritten { get; set; }

    public int Status { get; private set; }
    public string Output { get; private set; }
    public string Error { get; private set; }

    public static CliCall Of(params string[] args) => Of(CancellationToken.None, args);

    public static CliCall Of(CancellationToken cancellation, params string[] args)
    {
        using var output = new StringWriter();
        using var error = new StringWriter();
        int status = CommandLine.Run(args, output, error, false, cancellation);
        int json = Array.LastIndexOf(args, "--json") + 1;
        string summary = json == 0 || json == args.Length ? "" : args[json] == "-" ? output.ToString()
            : File.Exists(args[json]) && status != ExitStatus.Usage ? File.ReadAllText(args[json]) : "";
        if (summary.Length > 0)
            SummaryWritten?.Invoke(string.Join(" ", args), summary);
        return new CliCall { Status = status, Output = output.ToString(), Error = error.ToString() };
    }

    public JsonElement Json => JsonDocument.Parse(Output).RootElement;
    public int ErrorLines => Error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length;
}
