namespace StandIns.Graphics;

sealed class ComputeSource
{
    internal readonly ShaderFiles Files;
    internal readonly string Name;
    internal readonly string Text;
    internal readonly List<string> Kernels = new List<string>();
    internal readonly KeywordGroup[] Keywords;

    internal ComputeSource(string path)
    {
        Files = new ShaderFiles(path);
        Name = Path.GetFileName(path);
        Text = File.ReadAllText(path);
        var keywords = new List<KeywordGroup>();
        foreach (string[] words in ShaderPragmas.Of(Text))
        {
            if (words[0] == "kernel" && words.Length > 2)
                throw new InvalidDataException($"{path}: kernel {words[1]} has definitions of its own, which is not "
                    + $"supported");
            if (words[0] == "kernel")
                Kernels.Add(words[1]);
            else if (KeywordGroup.TryRead(words) is { } group)
                keywords.Add(group);
        }
        if (Kernels.Count == 0)
            throw new InvalidDataException($"{path}: has no #pragma kernel");
        Keywords = keywords.ToArray();
    }

    internal ShaderStage Kernel(string kernel, long variant) =>
        new ShaderStage(Files, Name, Text, "comp", kernel, KeywordVariant.Names(Keywords, variant, "comp").ToArray());
}
