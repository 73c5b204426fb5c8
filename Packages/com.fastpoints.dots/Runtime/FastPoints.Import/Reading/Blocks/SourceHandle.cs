using Unity.IO.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    // Opened at the first read: threads of the pool open readers, but handles belong to the main thread.
    sealed class SourceHandle
    {
        FileHandle m_handle;
        bool m_isOpen;

        public SourceHandle(string path) => Path = path;

        public string Path { get; }

        public ref readonly FileHandle Open()
        {
            if (!m_isOpen)
                m_handle = AsyncReadManager.OpenFileAsync(System.IO.Path.GetFullPath(Path));
            m_isOpen = true;
            return ref m_handle;
        }

        public void Close()
        {
            if (m_isOpen)
                m_handle.Close().Complete();
            m_isOpen = false;
        }
    }
}
