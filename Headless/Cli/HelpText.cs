namespace FastPoints.Cli;

/// <summary>What <c>--help</c> says: from the commands themselves, so that it cannot lag behind them.</summary>
public static class HelpText
{
    const int Width = 100;

    public static string Path(Command command) => command is RootCommand ? "./fastpoints" : "./fastpoints " + command.Name;

    public static string Usage(Command command)
    {
        var words = new List<string> { Path(command) };
        foreach (var argument in command.Arguments)
        {
            string name = argument.Arity.MaximumNumberOfValues > 1 ? argument.Name + "..." : argument.Name;
            words.Add(argument.Arity.MinimumNumberOfValues == 0 ? "[" + name + "]" : name);
        }
        foreach (var option in command.Options.Where(o => o.Required))
            words.Add((option.Aliases.FirstOrDefault() ?? option.Name) + " " + option.HelpName);
        words.Add("[options]");
        return string.Join(" ", words);
    }

    public static void Write(TextWriter writer, List<Verb> verbs, Command command, CommonOptions common)
    {
        var verb = verbs.First(v => v.Command == command);
        bool isRoot = command is RootCommand;
        writer.WriteLine("usage: " + Usage(command));
        if (isRoot)
            writer.WriteLine("       ./fastpoints VERB [options]");
        writer.WriteLine();
        Wrap(writer, "", "", command.Description!);
        if (isRoot)
        {
            writer.WriteLine();
            writer.WriteLine("Verbs (each has its own --help):");
            foreach (var other in verbs.Skip(1))
                Wrap(writer, "  " + other.Command.Name, "".PadRight(16), other.Command.Description!);
        }
        WriteOptions(writer, command, common);
        writer.WriteLine();
        writer.WriteLine("Examples:");
        foreach (var (line, what) in isRoot ? verbs.SelectMany(v => v.Examples) : verb.Examples)
            writer.WriteLine("  " + line.PadRight(62) + "  " + what);
        if (!isRoot)
            return;
        writer.WriteLine();
        foreach (string note in s_notes)
            writer.WriteLine(note);
    }

    static readonly string[] s_notes =
    [
        "Exit status: 0 done, 1 failed, 2 wrong usage, 3 the input is bad, 130 cancelled, 4 incomplete (--strict).",
        "Ctrl-C leaves nothing half-written, but a build that can go on: the same line does. A second one meanwhile deletes it.",
        "Options that all verbs have may stand before the verb; behind -- are files only. Counts may be 500k, 2M, 1e6.",
        "- is standard input; for points (LAS, or -.laz, -.ply) and summaries standard output; by way of files in TMPDIR.",
        "Lengths are metres, times seconds, sizes bytes, unless the name says otherwise.",
    ];

    public static void WriteManual(TextWriter writer, List<Verb> verbs, CommonOptions common)
    {
        // Backslashes, hyphens, and what begins a line as a request would, are not text to it.
        static string Text(string text) =>
            (text[0] is '.' or '\'' ? "\\&" : "") + text.Replace("\\", "\\e").Replace("-", "\\-");
        void Line(string request, string text) => writer.Write(request + Text(text) + "\n");
        void Options(IEnumerable<Option> options)
        {
            foreach (var option in options.Where(o => !o.Hidden))
            {
                Line(".TP\n", Names(option));
                Line("", option.Description!);
            }
        }

        writer.Write(".TH FASTPOINTS 1\n.SH NAME\n");
        Line("fastpoints \\- ", "point clouds: look, convert, prove, export");
        writer.Write(".SH SYNOPSIS\n");
        foreach (var verb in verbs)
            Line(verb == verbs[0] ? "" : ".br\n", Usage(verb.Command).Replace("./fastpoints", "fastpoints"));
        writer.Write(".SH DESCRIPTION\n");
        Line("", verbs[0].Command.Description!);
        foreach (var verb in verbs)
        {
            Line(".SH ", verb == verbs[0] ? "OPTIONS" : verb.Command.Name.ToUpperInvariant());
            if (verb != verbs[0])
                Line("", verb.Command.Description!);
            foreach (var argument in verb.Command.Arguments)
            {
                Line(".TP\n", argument.Name);
                Line("", argument.Description!);
            }
            Options(verb.Command.Options.Except(common.All));
        }
        writer.Write(".SH OPTIONS OF ALL VERBS\n");
        Options(common.All);
        writer.Write(".SH EXAMPLES\n");
        foreach (var (line, what) in verbs.SelectMany(v => v.Examples))
        {
            Line(".TP\n", line);
            Line("", what);
        }
        writer.Write(".SH NOTES\n");
        foreach (string note in s_notes)
            Line(".PP\n", note);
    }

    static string Names(Option option)
    {
        string? letter = option.Aliases.FirstOrDefault(a => a.Length == 2 && a[0] == '-' && char.IsLetter(a[1]));
        return (letter == null ? option.Name : letter + ", " + option.Name)
            + (option.HelpName == null ? "" : " " + option.HelpName);
    }

    static void WriteOptions(TextWriter writer, Command command, CommonOptions common)
    {
        writer.WriteLine();
        writer.WriteLine("Options:");
        foreach (var argument in command.Arguments)
            Wrap(writer, "  " + argument.Name, "".PadRight(26), argument.Description!);
        foreach (var option in command.Options.Except(common.All).Where(o => !o.Hidden).Concat(common.All))
            Wrap(writer, "  " + Names(option), "".PadRight(26), option.Description!);
    }

    static void Wrap(TextWriter writer, string head, string indent, string text)
    {
        string line = head.Length < indent.Length ? head.PadRight(indent.Length) : head.Length == 0 ? "" : head + "  ";
        bool hasWord = false;
        foreach (string word in text.Split(' '))
        {
            if (hasWord && line.Length + 1 + word.Length > Width)
            {
                writer.WriteLine(line);
                line = indent;
                hasWord = false;
            }
            line += hasWord ? " " + word : word;
            hasWord = true;
        }
        writer.WriteLine(line);
    }
}
