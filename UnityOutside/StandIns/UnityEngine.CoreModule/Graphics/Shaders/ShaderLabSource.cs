namespace StandIns.Graphics;

sealed class ShaderLabSource(string name, ShaderFiles files)
{
    internal readonly string Name = name;
    internal readonly ShaderFiles Files = files;
    internal readonly List<ShaderPass> Passes = new List<ShaderPass>();
    internal readonly PropertySheet Defaults = new PropertySheet();

    internal ShaderPass Pass(int index)
    {
        if ((uint)index >= (uint)Passes.Count)
            throw new ArgumentOutOfRangeException(nameof(index), $"{Name}: pass {index} of {Passes.Count}");
        return Passes[index];
    }
}
