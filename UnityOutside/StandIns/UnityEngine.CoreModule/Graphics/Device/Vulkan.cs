namespace StandIns.Graphics;

/// <summary>Silk.NET's bindings of Vulkan. A process that draws nothing never comes here, and so never loads the
/// library.</summary>
static class Vulkan
{
    internal static readonly Vk Api = Vk.GetApi();

    internal static void Check(Result result, string what)
    {
        if (result < 0)
            throw new InvalidOperationException($"{what}: Vulkan says {result}");
    }
}
