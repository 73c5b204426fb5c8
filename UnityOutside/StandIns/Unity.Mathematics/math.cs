namespace Unity.Mathematics;

public static partial class math
{
    public const float FLT_MIN_NORMAL = 1.1754944E-38f;
    public const float PI = 3.1415927f;
    public const double PI_DBL = 3.141592653589793;
    public const float TODEGREES = 57.29578f;
    public const float TORADIANS = 0.017453292f;
    public const double TORADIANS_DBL = 0.017453292519943295;
}
