namespace UnityEngine;

public partial struct Mathf
{
    public const float PI = MathF.PI;

    public static float Sin(float f) => MathF.Sin(f);
    public static float Cos(float f) => MathF.Cos(f);
}
