namespace Unity.Entities;

[Flags]
public enum WorldSystemFilterFlags : uint
{
    Default = 1,
    Disabled = 2,
    Editor = 64,
    LocalSimulation = 256,
    Presentation = 4096,
    All = 4294967295,
}
