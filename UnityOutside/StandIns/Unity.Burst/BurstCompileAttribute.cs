namespace Unity.Burst;

/// <summary>Marks a job struct or a static method for Burst. Here it marks only: the host's own compiler runs the code.</summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Method | AttributeTargets.Assembly)]
public class BurstCompileAttribute : Attribute
{
    public BurstCompileAttribute() { }

    public BurstCompileAttribute(FloatPrecision floatPrecision, FloatMode floatMode) =>
        (FloatPrecision, FloatMode) = (floatPrecision, floatMode);

    public FloatMode FloatMode { get; set; }
    public FloatPrecision FloatPrecision { get; set; }
}
