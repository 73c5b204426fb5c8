namespace StandIns.Graphics;

sealed class TemporaryTextures
{
    readonly Dictionary<int, RenderTexture> m_byName = new Dictionary<int, RenderTexture>();
    readonly List<RenderTexture> m_idle = new List<RenderTexture>();

    internal RenderTexture CameraTarget { get; set; } // Of the camera whose command buffers are executed; null if none draws.

    internal RenderTexture Get(int name, in RenderTextureDescriptor descriptor, FilterMode filter)
    {
        Release(name);
        RenderTexture found = null;
        for (int i = 0; i < m_idle.Count && found == null; i++)
            if (m_idle[i].Descriptor.IsSameAs(descriptor))
            {
                found = m_idle[i];
                m_idle.RemoveAt(i);
            }
        found ??= new RenderTexture(descriptor) { name = PropertyNames.NameOf(name) };
        found.filterMode = filter;
        m_byName.Add(name, found);
        return found;
    }

    internal void ReleaseAll()
    {
        foreach ((int name, RenderTexture texture) in m_byName)
        {
            PropertySheet.Global.Set(name, (Texture)null);
            m_idle.Add(texture);
        }
        m_byName.Clear();
    }

    internal void Release(int name)
    {
        if (m_byName.Remove(name, out RenderTexture texture))
            m_idle.Add(texture);
    }

    /// <summary>The texture that an identifier stands for; null if it stands for none.</summary>
    internal Texture Resolve(in RenderTargetIdentifier target)
    {
        if (target.IsNone)
            return null;
        if (target.IsCameraTarget)
            return CameraTarget ?? throw new InvalidOperationException($"{target}: no camera draws");
        if (target.NameId < 0)
            return target.Texture ?? throw new InvalidOperationException($"{target}: there is no such texture (any more)");
        if (m_byName.TryGetValue(target.NameId, out RenderTexture texture))
            return texture;
        if (PropertySheet.Global.TryGet(target.NameId, out PropertyValue value) && value.Reference is Texture global)
            return global;
        throw new InvalidOperationException($"No temporary or global texture has the name {target}");
    }
}
