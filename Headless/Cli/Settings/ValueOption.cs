namespace FastPoints.Cli.Settings;

sealed class ValueOption<T> : Option<T>
{
    public ValueOption(string name, string valueName, string description) : base(name) =>
        (HelpName, Description) = (valueName, description);

    public ValueOption(string name, string valueName, string description, T fallback) : this(name, valueName, description) =>
        DefaultValueFactory = _ => fallback;
}

sealed class Inputs : Argument<string[]>
{
    public Inputs(string name, string description) : base(name) => (Description, Arity) = (description, ArgumentArity.OneOrMore);
}

sealed class Flag : Option<bool>
{
    public Flag(string name, string description) : base(name) => Description = description;
}

static class Commands
{
    public static void Add(this Command command, params ReadOnlySpan<Symbol> symbols)
    {
        foreach (var symbol in symbols)
        {
            if (symbol is Argument argument)
                command.Add(argument);
            else
                command.Add((Option)symbol);
        }
    }
}
