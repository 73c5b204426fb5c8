using System;
using Unity.Collections;

namespace FastPoints.Drawing
{
    // Tables of 256 sRGB colours, one byte each from the lowest: red, green, blue, alpha.
    internal static class Palettes
    {
        public const int Length = 256;
        public const int Count = 6; // Three ramps, three of categories.

        // Where ramps start: darker values would be lost against a dark background.
        const double ViridisStart = 0.12, GrayStart = 0.03;

        // Grey for Rgb, which needs none. The ramp is for continuous attributes alone.
        public static NativeArray<uint> Create(ColorMode mode, Allocator allocator, ColorRamp ramp = ColorRamp.Auto)
        {
            ramp = Resolve(mode, ramp);
            var palette = new NativeArray<uint>(Length, allocator, NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < Length; i++)
            {
                palette[i] = mode switch
                {
                    ColorMode.Classification => s_classes[Math.Min(i, s_classes.Length - 1)],
                    ColorMode.ReturnNumber => FromHsv(0.1 + 0.13 * i, 0.75, 0.95),
                    // Steps of the golden ratio make neighbours differ, and no hue comes twice.
                    ColorMode.PointSource => FromHsv(i * 0.6180339887, 0.45 + 0.4 * (i % 3) / 2, 0.95 - 0.3 * (i % 2)),
                    _ => ColorAt(ramp, i / (Length - 1.0)),
                };
            }
            return palette;
        }

        public static int IndexOf(ColorMode mode, ColorRamp ramp = ColorRamp.Auto) => mode switch
        {
            ColorMode.Classification => 3,
            ColorMode.ReturnNumber => 4,
            ColorMode.PointSource => 5,
            _ => (int)Resolve(mode, ramp) - (int)ColorRamp.Viridis,
        };

        public static NativeArray<uint> CreateAll(Allocator allocator)
        {
            var all = new NativeArray<uint>(Count * Length, allocator, NativeArrayOptions.UninitializedMemory);
            void Add(ColorMode mode, ColorRamp ramp)
            {
                using var one = Create(mode, Allocator.Temp, ramp);
                NativeArray<uint>.Copy(one, 0, all, IndexOf(mode, ramp) * Length, Length);
            }
            for (var ramp = ColorRamp.Viridis; ramp <= ColorRamp.Gray; ramp++)
                Add(ColorMode.Elevation, ramp);
            Add(ColorMode.Classification, ColorRamp.Auto);
            Add(ColorMode.ReturnNumber, ColorRamp.Auto);
            Add(ColorMode.PointSource, ColorRamp.Auto);
            return all;
        }

        static ColorRamp Resolve(ColorMode mode, ColorRamp ramp) => ramp != ColorRamp.Auto ? ramp
            : mode == ColorMode.Elevation ? ColorRamp.Viridis : ColorRamp.Gray;

        static uint ColorAt(ColorRamp ramp, double t) => ramp switch
        {
            ColorRamp.Viridis => Viridis(ViridisStart + (1 - ViridisStart) * t),
            ColorRamp.Turbo => Turbo(t),
            _ => Gray(GrayStart + (1 - GrayStart) * t),
        };

        // The hue circle (Smith, "Color gamut transform pairs", 1978): a turn is red, green at a third, blue at two; saturation
        // 0 is grey, value that of the brightest channel, sRGB.
        static uint FromHsv(double turns, double saturation, double value)
        {
            byte Channel(double shift)
            {
                double place = turns + shift;
                double distance = Math.Abs((place - Math.Floor(place)) * 6 - 3);
                return ToByte(value * (1 - saturation * (1 - Math.Min(1, Math.Max(0, distance - 1)))));
            }
            return Pack(Channel(0), Channel(2 / 3.0), Channel(1 / 3.0));
        }

        public static uint Pack(byte red, byte green, byte blue, byte alpha = 255) =>
            red | (uint)green << 8 | (uint)blue << 16 | (uint)alpha << 24;

        public static uint Gray(double linear)
        {
            byte value = ToByte(LinearToSrgb(linear));
            return Pack(value, value, value);
        }

        // sRGB (IEC 61966-2-1), both from 0 to 1.
        public static double LinearToSrgb(double linear) =>
            linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.Pow(linear, 1 / 2.4) - 0.055;

        // Indexed by sRGB byte.
        public static NativeArray<float> CreateSrgbToLinear(Allocator allocator)
        {
            var linear = new NativeArray<float>(256, allocator, NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < linear.Length; i++)
                linear[i] = (float)(i <= 10 ? i / 255.0 / 12.92 : Math.Pow((i / 255.0 + 0.055) / 1.055, 2.4));
            return linear;
        }

        // Viridis (Smith and van der Walt, 2015): even steps of lightness and hue in CAM02-UCS. Polynomials of degree six over
        // its sRGB values (fit by M. Zucker, CC0), at most 5 of 255 off; evaluated at each entry, so nothing is interpolated.
        public static uint Viridis(double t)
        {
            double red = Polynomial(t, 0.27772733, 0.10509304, -0.33086183, -4.63423050, 6.22826994, 4.77638500, -5.43545586);
            double green = Polynomial(t, 0.00540734, 1.40461353, 0.21484756, -5.79910097, 14.17993337, -13.74514538,
                4.64585261);
            double blue = Polynomial(t, 0.33409981, 1.38459016, 0.09509516, -19.33244096, 56.69055260, -65.35303263,
                26.31243525);
            return Pack(ToByte(red), ToByte(green), ToByte(blue));
        }

        // Turbo (Mikhailov, 2019): the rainbow with smooth lightness. Polynomials of degree five over its sRGB values (fit by
        // R. Du), at most an eighth off, at the ends.
        public static uint Turbo(double t)
        {
            double red = Polynomial(t, 0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943);
            double green = Polynomial(t, 0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604);
            double blue = Polynomial(t, 0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973);
            return Pack(ToByte(red), ToByte(green), ToByte(blue));
        }

        internal static double Polynomial(double x, params double[] coefficients)
        {
            double sum = 0;
            for (int i = coefficients.Length - 1; i >= 0; i--)
                sum = coefficients[i] + x * sum;
            return sum;
        }

        internal static byte ToByte(double channel) => (byte)Math.Min(255, Math.Max(0, channel * 255 + 0.5));

        // Common colours of ASPRS classes (LAS 1.4 R15, table 17); the last is for all others.
        static readonly uint[] s_classes =
        {
            Pack(160, 160, 160), // 0 created, never classified
            Pack(200, 200, 200), // 1 unclassified
            Pack(165, 125, 80),  // 2 ground
            Pack(125, 190, 90),  // 3 low vegetation
            Pack(70, 155, 60),   // 4 medium vegetation
            Pack(25, 110, 40),   // 5 high vegetation
            Pack(225, 120, 85),  // 6 building
            Pack(255, 0, 255),   // 7 low point (noise)
            Pack(235, 225, 95),  // 8 model key point
            Pack(60, 130, 215),  // 9 water
            Pack(150, 100, 160), // 10 rail
            Pack(105, 105, 115), // 11 road surface
            Pack(245, 235, 200), // 12 overlap
            Pack(240, 205, 60),  // 13 wire guard
            Pack(255, 165, 0),   // 14 wire conductor
            Pack(190, 70, 140),  // 15 transmission tower
            Pack(255, 215, 130), // 16 wire connector
            Pack(130, 160, 190), // 17 bridge deck
            Pack(255, 60, 60),   // 18 high noise
            Pack(200, 170, 110), // 19 overhead structure
            Pack(120, 95, 70),   // 20 ignored ground
            Pack(235, 245, 255), // 21 snow
            Pack(180, 80, 80),   // 22 temporal exclusion
            Pack(140, 200, 200), // others
        };
    }

    /// <summary>The colours of continuous attributes, from low to high.</summary>
    public enum ColorRamp
    {
        /// <summary>Viridis for elevation, grey for intensity.</summary>
        Auto,

        /// <summary>Perceptually even, also for people with colour vision deficiency.</summary>
        Viridis,

        /// <summary>The rainbow's colours: distinguishes more values, less evenly.</summary>
        Turbo,

        /// <summary>Light is in proportion to the value.</summary>
        Gray,
    }
}
