namespace StandIns.Graphics;

/// <summary>Samplers by what they do. A shader names one as sampler_Name after the texture whose own it is, or by what it does:
/// sampler_PointClamp, sampler_linear_repeat. Depth is never filtered.</summary>
sealed unsafe class SamplerTable(GpuDevice device)
{
    const string Prefix = "sampler";

    readonly GpuDevice m_device = device;
    readonly Dictionary<(FilterMode, TextureWrapMode), Sampler> m_samplers = new();
    readonly Dictionary<int, int> m_textureOf = new Dictionary<int, int>(); // By the name of the sampler: of the texture, or -1.

    internal Sampler Find(ShaderResource sampler, in PropertyScope scope)
    {
        if (!m_textureOf.TryGetValue(sampler.NameId, out int name))
        {
            bool isOfTexture = sampler.Name.StartsWith(Prefix, StringComparison.Ordinal);
            name = isOfTexture ? PropertyNames.IdOf(sampler.Name[Prefix.Length..]) : -1;
            m_textureOf.Add(sampler.NameId, name);
        }
        if (name >= 0 && scope.TryGet(name, out PropertyValue value) && value.Reference is Texture texture)
            return Find(texture.ImageFor(value.IsDepth).IsDepth ? FilterMode.Point : texture.filterMode, texture.wrapMode);
        return Find(Says(sampler.Name, "linear") ? FilterMode.Bilinear : FilterMode.Point,
            Says(sampler.Name, "repeat") ? TextureWrapMode.Repeat : TextureWrapMode.Clamp);
    }

    static bool Says(string name, string word) => name.IndexOf(word, StringComparison.OrdinalIgnoreCase) >= 0;

    Sampler Find(FilterMode filter, TextureWrapMode wrap)
    {
        if (m_samplers.TryGetValue((filter, wrap), out Sampler sampler))
            return sampler;
        Filter texels = filter == FilterMode.Point ? Filter.Nearest : Filter.Linear;
        SamplerAddressMode edge = wrap == TextureWrapMode.Repeat ? SamplerAddressMode.Repeat
            : wrap == TextureWrapMode.Mirror ? SamplerAddressMode.MirroredRepeat : SamplerAddressMode.ClampToEdge;
        var create = new SamplerCreateInfo(magFilter: texels, minFilter: texels, addressModeU: edge, addressModeV: edge,
            addressModeW: edge);
        Check(Api.CreateSampler(m_device.Handle, &create, null, &sampler), "vkCreateSampler");
        m_samplers.Add((filter, wrap), sampler);
        return sampler;
    }
}
