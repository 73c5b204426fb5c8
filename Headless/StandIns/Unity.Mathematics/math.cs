namespace Unity.Mathematics;

public static partial class math
{
    public const double DBL_MIN_NORMAL = 2.2250738585072014E-308;
    public const float E = 2.7182817f;
    public const float EPSILON = 1.1920929E-07f;
    public const double EPSILON_DBL = 2.220446049250313E-16;
    public const double E_DBL = 2.718281828459045;
    public const float FLT_MIN_NORMAL = 1.1754944E-38f;
    public const float INFINITY = float.PositiveInfinity;
    public const double INFINITY_DBL = double.PositiveInfinity;
    public const float LN10 = 2.3025851f;
    public const double LN10_DBL = 2.302585092994046;
    public const float LN2 = 0.6931472f;
    public const double LN2_DBL = 0.6931471805599453;
    public const float LOG10E = 0.4342945f;
    public const double LOG10E_DBL = 0.4342944819032518;
    public const float LOG2E = 1.442695f;
    public const double LOG2E_DBL = 1.4426950408889634;
    public const float NAN = float.NaN;
    public const double NAN_DBL = double.NaN;
    public const float PI = 3.1415927f;
    public const float PI2 = 6.2831855f;
    public const double PI2_DBL = 6.283185307179586;
    public const float PIHALF = 1.5707964f;
    public const double PIHALF_DBL = 1.5707963267948966;
    public const double PI_DBL = 3.141592653589793;
    public const float SQRT2 = 1.4142135f;
    public const double SQRT2_DBL = 1.4142135623730951;
    public const float TAU = 6.2831855f;
    public const double TAU_DBL = 6.283185307179586;
    public const float TODEGREES = 57.29578f;
    public const double TODEGREES_DBL = 57.29577951308232;
    public const float TORADIANS = 0.017453292f;
    public const double TORADIANS_DBL = 0.017453292519943295;
}
