using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>FLIP of a tile of two pictures. Each row is filtered along x and kept as long as rows below need it, then the
    /// rows are filtered along y. Beyond its edges a picture goes on with the pixels of its edges.</summary>
    [BurstCompile]
    internal unsafe struct CompareTilesJob : IJobFor
    {
        // At 67 pixels per degree the kept rows are 172 KB, and a sixth of the rows along x is filtered twice.
        const int Edge = 128;

        // Of a pixel before filtering: an opponent colour of the picture, one of the reference.
        const int ColorFloats = 6;

        // Of a pixel filtered along x: Y, Cx and both parts of Cz, then the Gaussian of light and its derivatives, of the
        // picture, then of the reference.
        const int Features = 4, FilteredFloats = 14, Reference = 7;

        [ReadOnly] public NativeArray<uint> Picture;
        [ReadOnly] public NativeArray<uint> ReferencePicture;
        public int Width;
        public int Height;
        [ReadOnly] public NativeArray<float> LinearOfByte;
        public FlipFilters Filters;

        [NativeDisableParallelForRestriction, WriteOnly] public NativeArray<float> Errors;
        [WriteOnly] public NativeArray<double> SumOfTile;

        public static int TileCount(int width, int height) => TilesAlong(width) * TilesAlong(height);

        public void Execute(int index)
        {
            int left = index % TilesAlong(Width) * Edge, top = index / TilesAlong(Width) * Edge;
            int columns = math.min(Edge, Width - left), radius = Filters.Radius, kept = 2 * radius + 1;
            var colors = new NativeArray<float>((columns + 2 * radius) * ColorFloats, Allocator.Temp);
            var filtered = new NativeArray<float>(kept * columns * FilteredFloats, Allocator.Temp);
            var rows = (float*)filtered.GetUnsafePtr();
            float** rowAround = stackalloc float*[kept];
            float largest = FlipColor.LargestDifference();
            double sum = 0;
            int next = math.max(0, top - radius);
            for (int y = top; y < math.min(Height, top + Edge); y++)
            {
                for (; next <= math.min(Height - 1, y + radius); next++)
                {
                    ReadRow((float*)colors.GetUnsafePtr(), next, left - radius, columns + 2 * radius);
                    FilterRow((float*)colors.GetUnsafePtr(), columns, rows + next % kept * columns * FilteredFloats);
                }
                for (int i = 0; i < kept; i++)
                    rowAround[i] = rows + math.clamp(y + i - radius, 0, Height - 1) % kept * columns * FilteredFloats;
                for (int x = 0; x < columns; x++)
                {
                    float error = ErrorAt(rowAround + radius, x * FilteredFloats, largest);
                    Errors[y * Width + left + x] = error;
                    sum += error;
                }
            }
            SumOfTile[index] = sum;
            colors.Dispose();
            filtered.Dispose();
        }

        static int TilesAlong(int pixels) => (pixels + Edge - 1) / Edge;

        void ReadRow(float* colors, int y, int left, int columns)
        {
            for (int x = 0; x < columns; x++)
            {
                int pixel = y * Width + math.clamp(left + x, 0, Width - 1);
                *(float3*)(colors + x * ColorFloats) = OpponentOf(Picture[pixel]);
                *(float3*)(colors + x * ColorFloats + 3) = OpponentOf(ReferencePicture[pixel]);
            }
        }

        float3 OpponentOf(uint rgba) => FlipColor.OpponentOf(
            LinearOfByte[(int)(rgba & 255)], LinearOfByte[(int)(rgba >> 8 & 255)], LinearOfByte[(int)(rgba >> 16 & 255)]);

        void FilterRow(float* colors, int columns, float* filtered)
        {
            for (int x = 0; x < columns; x++)
            {
                float* color = colors + (x + Filters.Radius) * ColorFloats;
                FilterAlongX(color, filtered + x * FilteredFloats);
                FilterAlongX(color + 3, filtered + x * FilteredFloats + Reference);
            }
        }

        void FilterAlongX(float* color, float* filtered)
        {
            var weights = (float*)Filters.Colors.GetUnsafeReadOnlyPtr();
            float y = weights[0] * color[0], cx = weights[1] * color[1];
            float first = weights[2] * color[2], second = weights[3] * color[2];
            for (int tap = 1; tap <= Filters.ColorRadius; tap++)
            {
                float* weight = weights + tap * FlipFilters.Stride;
                float* before = color - tap * ColorFloats;
                float* after = color + tap * ColorFloats;
                float cz = before[2] + after[2];
                y += weight[0] * (before[0] + after[0]);
                cx += weight[1] * (before[1] + after[1]);
                first += weight[2] * cz;
                second += weight[3] * cz;
            }
            filtered[0] = y;
            filtered[1] = cx;
            filtered[2] = first;
            filtered[3] = second;
            weights = (float*)Filters.Features.GetUnsafeReadOnlyPtr();
            float gaussian = weights[0] * color[0], slope = 0, curve = weights[2] * color[0];
            for (int tap = 1; tap <= Filters.FeatureRadius; tap++)
            {
                float* weight = weights + tap * FlipFilters.Stride;
                float before = color[-tap * ColorFloats], after = color[tap * ColorFloats];
                gaussian += weight[0] * (before + after);
                slope += weight[1] * (before - after);
                curve += weight[2] * (before + after);
            }
            filtered[Features] = gaussian;
            filtered[Features + 1] = slope;
            filtered[Features + 2] = curve;
        }

        /// <param name="rows">The pixel's own row; others are before and after it.</param>
        float ErrorAt(float** rows, int at, float largest)
        {
            var lab = FilterColors(rows, at);
            var labOfReference = FilterColors(rows, at + Reference);
            float error = FlipColor.ErrorOf(lab, labOfReference, largest);
            if (error <= 0)
                return 0;
            FilterFeatures(rows, at + Features, out float edge, out float point);
            FilterFeatures(rows, at + Reference + Features, out float edgeOfReference, out float pointOfReference);
            float feature = math.max(math.abs(edge - edgeOfReference), math.abs(point - pointOfReference));
            return math.pow(error, 1 - math.sqrt(feature * math.sqrt(0.5f)));
        }

        float3 FilterColors(float** rows, int at)
        {
            var weights = (float*)Filters.Colors.GetUnsafeReadOnlyPtr();
            float* row = rows[0] + at;
            float y = weights[0] * row[0], cx = weights[1] * row[1], first = weights[2] * row[2], second = weights[3] * row[3];
            for (int tap = 1; tap <= Filters.ColorRadius; tap++)
            {
                float* weight = weights + tap * FlipFilters.Stride;
                float* before = rows[-tap] + at;
                float* after = rows[tap] + at;
                y += weight[0] * (before[0] + after[0]);
                cx += weight[1] * (before[1] + after[1]);
                first += weight[2] * (before[2] + after[2]);
                second += weight[3] * (before[3] + after[3]);
            }
            return FlipColor.LabOf(y, cx, first + second);
        }

        /// <summary>How strong an edge and a point at a pixel are: the lengths of the first and second derivatives.</summary>
        void FilterFeatures(float** rows, int at, out float edge, out float point)
        {
            var weights = (float*)Filters.Features.GetUnsafeReadOnlyPtr();
            float* row = rows[0] + at;
            float slopeX = weights[0] * row[1], curveX = weights[0] * row[2], slopeY = 0, curveY = weights[2] * row[0];
            for (int tap = 1; tap <= Filters.FeatureRadius; tap++)
            {
                float* weight = weights + tap * FlipFilters.Stride;
                float* before = rows[-tap] + at;
                float* after = rows[tap] + at;
                slopeX += weight[0] * (before[1] + after[1]);
                curveX += weight[0] * (before[2] + after[2]);
                slopeY += weight[1] * (before[0] - after[0]);
                curveY += weight[2] * (before[0] + after[0]);
            }
            edge = math.sqrt(slopeX * slopeX + slopeY * slopeY);
            point = math.sqrt(curveX * curveX + curveY * curveY);
        }
    }
}
