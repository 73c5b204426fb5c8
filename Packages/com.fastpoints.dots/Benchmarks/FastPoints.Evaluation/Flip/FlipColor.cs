using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>The colours of FLIP. An opponent colour is (Y, X - Y, Y - Z) of CIE XYZ as shares of the white of D65: Y, Cx and
    /// Cz of YCxCz without their factors, which linear filters need not.</summary>
    internal static class FlipColor
    {
        // The paper's exponent of colour differences, and the share of the largest difference that becomes 0.95 of the error.
        const float ColorExponent = 0.7f, ShareOfKnee = 0.4f, ErrorAtKnee = 0.95f;

        public static float3 OpponentOf(float red, float green, float blue)
        {
            var xyz = XyzOf(red, green, blue);
            return new float3(xyz.y, xyz.x - xyz.y, xyz.y - xyz.z);
        }

        /// <summary>CIELAB with the Hunt effect: less light, less colour. What no screen shows is brought into its
        /// range.</summary>
        public static float3 LabOf(float y, float cx, float cz)
        {
            float x = (y + cx) * 0.950428545f, z = (y - cz) * 1.088900371f;
            float red = math.clamp(3.241003275f * x - 1.537398934f * y - 0.498615861f * z, 0, 1);
            float green = math.clamp(-0.969224334f * x + 1.875930071f * y + 0.041554224f * z, 0, 1);
            float blue = math.clamp(0.055639423f * x - 0.204011202f * y + 1.057148933f * z, 0, 1);
            var xyz = XyzOf(red, green, blue);
            float fx = Root(xyz.x), fy = Root(xyz.y), fz = Root(xyz.z);
            float lightness = 116 * fy - 16, hunt = 0.01f * lightness;
            return new float3(lightness, hunt * 500 * (fx - fy), hunt * 200 * (fy - fz));
        }

        /// <summary>What of a colour difference is seen, 0 to 1.</summary>
        /// <param name="maxDifference">See <see cref="MaxDifference"/>.</param>
        public static float ErrorOf(float3 lab, float3 labOfReference, float maxDifference)
        {
            float difference = Distance(lab, labOfReference);
            if (difference <= 0)
                return 0;
            difference = math.pow(difference, ColorExponent);
            float knee = ShareOfKnee * maxDifference;
            return difference < knee ? difference * (ErrorAtKnee / knee)
                : ErrorAtKnee + (difference - knee) / (maxDifference - knee) * (1 - ErrorAtKnee);
        }

        /// <summary>Between green and blue, the two colours of sRGB that differ most.</summary>
        public static float MaxDifference()
        {
            var green = OpponentOf(0, 1, 0);
            var blue = OpponentOf(0, 0, 1);
            return math.pow(Distance(LabOf(green.x, green.y, green.z), LabOf(blue.x, blue.y, blue.z)), ColorExponent);
        }

        // HyAB: city blocks between lightness and colour.
        static float Distance(float3 a, float3 b)
        {
            float da = a.y - b.y, db = a.z - b.z;
            return math.abs(a.x - b.x) + math.sqrt(da * da + db * db);
        }

        static float3 XyzOf(float red, float green, float blue)
        {
            const float PerX = 1.052156925f / 24577794, PerY = 1f / 12288897, PerZ = 0.918357670f / 73733382;
            return new float3(
                PerX * 10135552 * red + PerX * 8788810 * green + PerX * 4435075 * blue,
                PerY * 2613072 * red + PerY * 8788810 * green + PerY * 887015 * blue,
                PerZ * 1425312 * red + PerZ * 8788810 * green + PerZ * 70074185 * blue);
        }

        // CIELAB's cube root, which is a line near black.
        static float Root(float share)
        {
            const float Delta = 6f / 29;
            return share > Delta * Delta * Delta ? CubeRoot(share) : share * (1 / (3 * Delta * Delta)) + 4f / 29;
        }

        // Halley's iteration, which triples the digits, from a third of the exponent (3 % off): five times math.pow's speed.
        static float CubeRoot(float x)
        {
            float root = math.asfloat(math.asuint(x) / 3 + 709921077u);
            float cube = root * root * root;
            root *= (cube + 2 * x) / (2 * cube + x);
            cube = root * root * root;
            return root * ((cube + 2 * x) / (2 * cube + x));
        }
    }
}
