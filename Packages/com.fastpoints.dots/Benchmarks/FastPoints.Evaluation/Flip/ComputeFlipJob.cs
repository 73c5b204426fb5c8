using Unity.Burst;
using Unity.Burst.Intrinsics;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>FLIP of a tile of two pictures. Each row is filtered along x and kept as long as rows below need it, then the
    /// rows are filtered along y. Beyond its edges a picture goes on with the pixels of its edges. All rows are planar, so that
    /// vectors of pixels are filtered at once.</summary>
    [BurstCompile]
    internal unsafe struct ComputeFlipJob : IJobFor
    {
        // At 67 pixels per degree the kept rows are 151 KB, and a twelfth of the rows along x is filtered twice.
        const int TileWidth = 128, TileHeight = 256;
        const int ColorPlanes = 3; // Planes of a row before filtering: an opponent colour of the picture, one of the reference.

        // Planes of a row filtered along x: Y, Cx and both parts of Cz, then the Gaussian of light and its derivatives.
        const int Gaussian = 4, Slope = 5, Curve = 6, FilteredPlanes = 7;

        // Planes of a row filtered along y, too: Y, Cx and both parts of Cz, then the first and the second derivatives.
        const int SlopeX = 4, SlopeY = 5, CurveX = 6, CurveY = 7, DonePlanes = 8;

        const int Lanes = 8;

        [ReadOnly] public NativeArray<uint> Picture;
        [ReadOnly] public NativeArray<uint> ReferencePicture;
        public int Width;
        public int Height;
        [ReadOnly] public NativeArray<float> LightOfByte;
        public FlipFilters Filters;

        [NativeDisableParallelForRestriction, WriteOnly] public NativeArray<float> Errors;
        [WriteOnly] public NativeArray<double> SumOfTile;

        public static int TileCount(int width, int height) => Tiles(width, TileWidth) * Tiles(height, TileHeight);

        static int Tiles(int pixels, int edge) => (pixels + edge - 1) / edge;

        public void Execute(int index)
        {
            int left = index % Tiles(Width, TileWidth) * TileWidth, top = index / Tiles(Width, TileWidth) * TileHeight;
            int columns = math.min(TileWidth, Width - left), radius = Filters.Radius, kept = 2 * radius + 1;
            int wide = columns + 2 * radius, floatsOfRow = 2 * FilteredPlanes * columns;
            var memory = new NativeArray<float>(2 * ColorPlanes * wide + kept * floatsOfRow + 2 * DonePlanes * columns,
                Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            float* colors = (float*)memory.GetUnsafePtr();
            float* rows = colors + 2 * ColorPlanes * wide;
            float* done = rows + kept * floatsOfRow;
            float** around = stackalloc float*[kept];
            float maxDifference = FlipColor.MaxDifference();
            double sum = 0;
            int next = math.max(0, top - radius);
            for (int y = top; y < math.min(Height, top + TileHeight); y++)
            {
                for (; next <= math.min(Height - 1, y + radius); next++)
                {
                    ReadRow(colors, next, left - radius, wide);
                    for (int i = 0; i < kept; i++)
                        around[i] = colors + i;
                    for (int picture = 0; picture < 2; picture++)
                        FilterAlongX(around + radius, picture * ColorPlanes * wide, wide,
                            rows + next % kept * floatsOfRow + picture * FilteredPlanes * columns, columns);
                }
                for (int i = 0; i < kept; i++)
                    around[i] = rows + math.clamp(y + i - radius, 0, Height - 1) % kept * floatsOfRow;
                for (int picture = 0; picture < 2; picture++)
                    FilterAlongY(around + radius, picture * FilteredPlanes * columns, done + picture * DonePlanes * columns,
                        columns);
                for (int x = 0; x < columns; x++)
                {
                    float error = ErrorOf(done + x, done + DonePlanes * columns + x, columns, maxDifference);
                    Errors[y * Width + left + x] = error;
                    sum += error;
                }
            }
            SumOfTile[index] = sum;
            memory.Dispose();
        }

        void ReadRow(float* colors, int y, int left, int count)
        {
            for (int x = 0; x < count; x++)
            {
                int pixel = y * Width + math.clamp(left + x, 0, Width - 1);
                var color = OpponentOf(Picture[pixel]);
                var colorOfReference = OpponentOf(ReferencePicture[pixel]);
                for (int plane = 0; plane < ColorPlanes; plane++)
                {
                    colors[plane * count + x] = color[plane];
                    colors[(ColorPlanes + plane) * count + x] = colorOfReference[plane];
                }
            }
        }

        float3 OpponentOf(uint rgba) => FlipColor.OpponentOf(
            LightOfByte[(int)(rgba & 255)], LightOfByte[(int)(rgba >> 8 & 255)], LightOfByte[(int)(rgba >> 16 & 255)]);

        // around: the row shifted by as many pixels; at: its first plane, of which each is wide.
        void FilterAlongX(float** around, int at, int wide, float* to, int columns)
        {
            for (int plane = 0; plane < Gaussian; plane++)
                Filter(around, at + math.min(plane, ColorPlanes - 1) * wide, Color(plane), to + plane * columns, columns);
            Filter(around, at, Feature(0), to + Gaussian * columns, columns);
            Filter(around, at, Feature(1), to + Slope * columns, columns);
            Filter(around, at, Feature(2), to + Curve * columns, columns);
        }

        // around: the rows above and below; at: their first plane.
        void FilterAlongY(float** around, int at, float* to, int columns)
        {
            for (int plane = 0; plane < Gaussian; plane++)
                Filter(around, at + plane * columns, Color(plane), to + plane * columns, columns);
            Filter(around, at + Slope * columns, Feature(0), to + SlopeX * columns, columns);
            Filter(around, at + Gaussian * columns, Feature(1), to + SlopeY * columns, columns);
            Filter(around, at + Curve * columns, Feature(0), to + CurveX * columns, columns);
            Filter(around, at + Gaussian * columns, Feature(2), to + CurveY * columns, columns);
        }

        Taps Color(int column) => new Taps
        {
            Weights = (float*)Filters.Colors.GetUnsafeReadOnlyPtr() + column,
            Radius = Filters.ColorRadius,
            Sign = 1,
        };

        Taps Feature(int column) => new Taps
        {
            Weights = (float*)Filters.Features.GetUnsafeReadOnlyPtr() + column,
            Radius = Filters.FeatureRadius,
            Sign = column == 1 ? -1 : 1,
        };

        struct Taps
        {
            public float* Weights;
            public int Radius;
            public float Sign; // 1 if the filter is even, -1 if it is odd.

            public readonly float Middle => Sign > 0 ? Weights[0] : 0;
        }

        static void Filter(float** around, int at, in Taps taps, float* to, int count)
        {
            int first = 0;
            if (X86.Avx2.IsAvx2Supported)
            {
                var sign = X86.Avx.mm256_set1_ps(taps.Sign);
                var middle = X86.Avx.mm256_set1_ps(taps.Middle);
                for (; first + Lanes <= count; first += Lanes)
                {
                    var sum = X86.Avx.mm256_mul_ps(middle, X86.Avx.mm256_loadu_ps(around[0] + at + first));
                    for (int tap = 1; tap <= taps.Radius; tap++)
                    {
                        var after = X86.Avx.mm256_mul_ps(sign, X86.Avx.mm256_loadu_ps(around[tap] + at + first));
                        var both = X86.Avx.mm256_add_ps(X86.Avx.mm256_loadu_ps(around[-tap] + at + first), after);
                        var weight = X86.Avx.mm256_set1_ps(taps.Weights[tap * FlipFilters.Stride]);
                        sum = X86.Avx.mm256_add_ps(sum, X86.Avx.mm256_mul_ps(weight, both));
                    }
                    X86.Avx.mm256_storeu_ps(to + first, sum);
                }
            }
            FilterScalar(around, at + first, taps, to + first, count - first);
        }

        /// <summary>The same, to the bit: Burst vectorizes it.</summary>
        static void FilterScalar(float** around, int at, in Taps taps, float* to, int count)
        {
            for (int x = 0; x < count; x++)
                to[x] = taps.Middle * around[0][at + x];
            for (int tap = 1; tap <= taps.Radius; tap++)
            {
                float* before = around[-tap] + at;
                float* after = around[tap] + at;
                float weight = taps.Weights[tap * FlipFilters.Stride];
                for (int x = 0; x < count; x++)
                    to[x] += weight * (before[x] + taps.Sign * after[x]);
            }
        }

        static float ErrorOf(float* picture, float* reference, int columns, float maxDifference)
        {
            var lab = LabOf(picture, columns);
            var labOfReference = LabOf(reference, columns);
            float error = FlipColor.ErrorOf(lab, labOfReference, maxDifference);
            if (error <= 0)
                return 0;
            float edge = Length(picture[SlopeX * columns], picture[SlopeY * columns]);
            float point = Length(picture[CurveX * columns], picture[CurveY * columns]);
            float edgeOfReference = Length(reference[SlopeX * columns], reference[SlopeY * columns]);
            float pointOfReference = Length(reference[CurveX * columns], reference[CurveY * columns]);
            float feature = math.max(math.abs(edge - edgeOfReference), math.abs(point - pointOfReference));
            return math.pow(error, 1 - math.sqrt(feature * math.sqrt(0.5f)));
        }

        static float3 LabOf(float* done, int columns) =>
            FlipColor.LabOf(done[0], done[columns], done[2 * columns] + done[3 * columns]);

        static float Length(float x, float y) => math.sqrt(x * x + y * y);
    }
}
