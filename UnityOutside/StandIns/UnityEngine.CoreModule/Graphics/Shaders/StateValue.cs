namespace StandIns.Graphics;

readonly struct StateValue
{
    readonly int m_number;
    readonly int m_name; // One more than the property's, so that the default is none.

    StateValue(int number, int name) => (m_number, m_name) = (number, name);

    internal static StateValue Of(int number) => new StateValue(number, 0);

    internal static StateValue Read(ShaderLabTokens tokens, string[] words)
    {
        if (tokens.TryTake("["))
        {
            int name = PropertyNames.IdOf(tokens.Take());
            tokens.Expect("]");
            return new StateValue(0, name + 1);
        }
        string word = tokens.Take();
        int number = Array.FindIndex(words, w => string.Equals(w, word, StringComparison.OrdinalIgnoreCase));
        return number >= 0 ? Of(number) : throw tokens.Error($"'{word}' is none of {string.Join(", ", words)}");
    }

    internal int Evaluate(in PropertyScope scope)
    {
        if (m_name == 0 || !scope.TryGet(m_name - 1, out PropertyValue value))
            return m_number;
        return value.Kind == PropertyKind.Int ? value.Int : (int)value.Vector.x;
    }
}
