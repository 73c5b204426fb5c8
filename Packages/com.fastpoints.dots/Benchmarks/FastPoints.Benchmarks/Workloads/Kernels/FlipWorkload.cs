using FastPoints.Drawing;
using FastPoints.Evaluation;
using FastPoints.Picture;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>FLIP of two pictures of 1920 by 1080 pixels at 67 pixels per degree, on all workers: a pattern, and the same with
    /// noise. Its points are pixels.</summary>
    public struct FlipWorkload : IWorkload
    {
        RgbaImage m_picture;
        RgbaImage m_reference;

        public string Name => "flip (pixels)";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_picture = new RgbaImage(1920, 1080);
            m_reference = new RgbaImage(1920, 1080);
            var random = new Unity.Mathematics.Random(context.Seed);
            for (int y = 0; y < m_picture.Height; y++)
            {
                for (int x = 0; x < m_picture.Width; x++)
                {
                    int noise = random.NextInt(32);
                    int red = Wave(0.11f * x), green = Wave(0.07f * y), blue = Wave(0.05f * (x + y));
                    m_reference[x, y] = Palettes.Pack((byte)red, (byte)green, (byte)blue);
                    m_picture[x, y] = Palettes.Pack((byte)(red + noise), (byte)(green + noise), (byte)(blue + noise));
                }
            }
        }

        public WorkloadResult Run()
        {
            FlipMap.Of(m_picture, m_reference);
            return new WorkloadResult
            {
                Points = m_picture.Width * m_picture.Height,
                Bytes = m_picture.Rgba.Length + m_reference.Rgba.Length,
            };
        }

        public void Dispose() { }

        static int Wave(float angle) => (int)(112 + 90 * math.sin(angle));
    }
}
