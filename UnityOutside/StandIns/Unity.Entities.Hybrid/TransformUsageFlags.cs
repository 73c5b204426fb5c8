namespace Unity.Entities;

[Flags]
public enum TransformUsageFlags
{
    None = 0,
    Renderable = 1,
    Dynamic = 2,
    WorldSpace = 4,
    NonUniformScale = 8,
    ManualOverride = 16,
}
